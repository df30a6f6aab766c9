// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/cpu/simd/records.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// One of two disks that meet each other and no one else, before and after.
struct BinaryDisk {
  simd::Record record;
  Real spin;
  Species species;
  Real flight_deviation2;  ///< out: largest squared distance from its straight flight, [d_s^2]
};

/// What became of pairs of them.
struct BinaryOutcome {
  std::int64_t touching = 0;  ///< pairs, summed over steps
  std::int64_t steps = 0;     ///< of a pair
  bool bad = false;           ///< an overlap too large, or a motion that is NaN
};

}  // namespace bagnold
