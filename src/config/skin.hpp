// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

inline constexpr double usual_skin = 0.35;  ///< [d_s]

/// How far neighbour lists reach beyond contact, [d_s]: what the scene says, else the usual, or 0.5
/// where steps of implicit damping are so long that lists are built often for the steps between, if
/// the box has room for it.
double skin(Scene const& scene);

}  // namespace bagnold
