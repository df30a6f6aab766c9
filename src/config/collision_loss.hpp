// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// How much more energy a head-on collision of two small disks loses with a scheme than it should,
/// relative to what it should lose:
///
///     <1 - e^2> / (1 - e(Q)^2) - 1,    e(Q) = exp(-pi (c/2) / sqrt(k - c^2/4))    P1 Eq. (7)
///
/// averaged over where in a step the contact begins; x'' = -k x - c x' while x < 0. It does not
/// depend on the speed. 0 where the closed form says nothing: disks that never separate, forces
/// that are not harmonic, no damping along the normal.
double collision_loss_error(Scene const& scene, std::string_view scheme, double time_step);

}  // namespace bagnold
