// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// Relative error of the energy lost in a head-on collision of two small disks with a scheme:
///
///     <1 - e^2> / (1 - e(Q)^2) - 1,    e(Q) = exp(-pi (c/2) / sqrt(k - c^2/4))    P1 Eq. (7)
///
/// averaged over the phase of a step at which the contact begins; x'' = -k x - c x' while x < 0. It
/// does not depend on the speed. 0 where there is no closed form: disks that never separate, forces
/// that are not harmonic, no damping along the normal.
double collision_loss_error(Scene const& scene, std::string_view scheme, double time_step);

}  // namespace bagnold
