// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/plan.hpp"

namespace bagnold {

/// Inertia M of the box of a scene at given stress, [m]: M dgammadot/dt = stress - sigma, both
/// stresses times the area of the box over L_x L_y. By default 0.5 stress/strain_rate^2: the rate
/// then follows the stress over a strain of about 0.5, whatever rate is the right one in a flow
/// with sigma ~ gammadot^2.
double box_inertia(Scene const& scene);

/// Least M for the time step of a scene, [m]: with less the control itself makes a box swing on a
/// packing.
double least_box_inertia(Scene const& scene);

/// Plan of a scene whose controller decides on pieces: a whole number of windows, each of a whole
/// number of pieces of `control_steps` steps. Throws InputError for too many.
Plan plan_of_control(Scene const& scene);

}  // namespace bagnold
