// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace bagnold {

/// How the equations of motion are stepped.
enum class Scheme {
  modified_velocity_verlet,  ///< the papers', P2 Eqs. 21-24: two evaluations of all forces a step
  two_stage_leapfrog         ///< one, and a second stage of the damping
};

/// Their names, as in input and output.
inline constexpr std::string_view papers_scheme = "modified-velocity-verlet";
inline constexpr std::string_view two_stage_scheme = "two-stage-leapfrog";

}  // namespace bagnold
