// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

inline constexpr double usual_skin = 0.35;  ///< [d_s]

/// How far neighbour lists reach beyond contact, [d_s]: what the scene says, else the usual, or
/// where lists are built often for the work between, if the box has room for it, 0.5 with implicit
/// damping, 0.7 with contacts as events.
double skin(Scene const& scene);

}  // namespace bagnold
