// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Numbers of copies of a box side by side along and across the flow.
struct Copies {
  std::int64_t along;   ///< k_x
  std::int64_t across;  ///< k_y

  /// Aspect of the box of all copies, given that of one.
  double aspect(double box_aspect) const {
    return box_aspect * static_cast<double>(across) / static_cast<double>(along);
  }
};

/// Finds k_x k_y = disks.count / count and k_y / k_x = disks.box_aspect / box_aspect, count and
/// box_aspect being those of the copied box. Throws InputError, which begins with `what`, if none
/// fit.
Copies copies_that_fit(std::string const& what, std::int64_t count, double box_aspect,
                       Scene const& scene);

/// Copies of a periodic state side by side, k_x along the flow and k_y across it, which fill the
/// box of disks.count and disks.box_aspect (copies_that_fit). A copy above another is its image
/// under Lees-Edwards conditions: shifted by the offset, and faster by gammadot L_y. The rate is
/// the scene's if the state has none or start.rescale is off, otherwise the state's, and the whole
/// is scaled. The flow is the same; disks of different copies separate as rounding errors grow, or
/// by noise of their own. Throws InputError if none fit.
State copies(State const& state, Scene const& scene);

}  // namespace bagnold
