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

  /// Of the box that they make of one.
  double aspect(double box_aspect) const {
    return box_aspect * static_cast<double>(across) / static_cast<double>(along);
  }
};

/// k_x k_y = disks.count / count, k_y / k_x = disks.box_aspect / box_aspect, those of the box that
/// is copied. Throws InputError, which begins with `what`, where none fit.
Copies copies_that_fit(std::string const& what, std::int64_t count, double box_aspect,
                       Scene const& scene);

/// Copies of a periodic state side by side, k_x along the flow and k_y across it, so many that they
/// fill the box of disks.count and disks.box_aspect (copies_that_fit). A copy above another is what
/// Lees-Edwards conditions have there: moved on by the offset, and faster by gammadot L_y, the rate
/// being the scene's where the state has none or start.rescale is off, else the state's, of which
/// the whole is scaled. The flow is the same; disks of different copies part as rounding errors
/// grow, or by noise of their own. Throws InputError where none fit.
State copies(State const& state, Scene const& scene);

}  // namespace bagnold
