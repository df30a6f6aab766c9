// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// How many copies of a box are set beside each other and above each other.
struct Copies {
  std::int64_t along;   ///< k_x
  std::int64_t across;  ///< k_y
};

/// k_x k_y = disks.count / count, k_y / k_x = disks.box_aspect / box_aspect, those of the box that
/// is copied. Throws InputError, which begins with `what`, where none fit.
Copies copies_that_fit(std::string const& what, std::int64_t count, double box_aspect,
                       Scene const& scene);

/// Copies of a periodic state side by side, k_x along the flow and k_y across it, so many that they
/// fill the box of disks.count and disks.box_aspect (copies_that_fit). A copy above another is what
/// Lees-Edwards conditions have there: moved on by the offset, and faster by strain_rate L_y, the
/// rate being the state's or, where it has none, the scene's. The flow is the same; disks of
/// different copies part as rounding errors grow. Throws InputError where none fit.
State copies(State const& state, Scene const& scene);

}  // namespace bagnold
