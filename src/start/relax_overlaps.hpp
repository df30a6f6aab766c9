// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/species.hpp"
#include "src/state/state.hpp"

namespace bagnold {

struct Relaxation {
  std::int64_t iterations;
  double largest_overlap;  ///< relative, what is left
};

/// Pushes overlapping disks apart at rest until the largest relative overlap is below `overlap` or
/// the iterations are used up. Runs on the host; the bits do not depend on which backend.
Relaxation relax_overlaps(State& state, double overlap, std::int64_t iterations, double skin);

}  // namespace bagnold
