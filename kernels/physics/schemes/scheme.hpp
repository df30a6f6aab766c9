// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// How the equations of motion are stepped.
enum class Scheme {
  modified_velocity_verlet,  ///< the papers', P2 Eqs. 21-24: two evaluations of all forces a step
  two_stage_leapfrog         ///< two_stage_leapfrog.hpp: one, and a second look at the damping
};

}  // namespace bagnold
