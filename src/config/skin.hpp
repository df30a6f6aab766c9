// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

inline constexpr double usual_skin = 0.35;  ///< [d_s]

/// Reach of neighbour lists beyond contact, [d_s]: as the scene says, otherwise usual_skin. It is
/// 0.5 with implicit damping and 0.7 with contacts as events, if the box is large enough: there
/// lists are built often for the work between.
double skin(Scene const& scene);

}  // namespace bagnold
