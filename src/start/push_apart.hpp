// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "src/state/state.hpp"

namespace bagnold {

struct Relaxation {
  std::int64_t iterations;
  double largest_overlap;  ///< relative, what is left
};

/// Thrown where a start is stopped from outside.
struct StartStopped {};

/// Iterations between two looks at the largest overlap.
inline constexpr std::int64_t between_checks = 10;

/// Pushes disks apart, one iteration at a time, until the largest relative overlap is at most
/// `overlap` or the iterations are used up. It bears any overlap. Runs on the host. Throws
/// StartStopped.
Relaxation push_apart(State& state, double overlap, std::int64_t iterations, double skin,
                      bool threads, std::function<bool()> const& go_on);

}  // namespace bagnold
