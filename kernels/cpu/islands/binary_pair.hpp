// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/cpu/simd/records.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// A disk of a pair that meets no other disk, before and after.
struct BinaryDisk {
  simd::Record record;
  Real spin;
  Species species;
  Real flight_deviation2;  ///< out: largest squared distance from its straight flight, [d_s^2]
};

/// Outcome for a pack of pairs.
struct BinaryOutcome {
  std::int64_t touching = 0;  ///< pairs, summed over steps
  std::int64_t steps = 0;     ///< of a pair
  bool bad = false;           ///< an overlap too large, or a motion that is NaN
};

}  // namespace bagnold
