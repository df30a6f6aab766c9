// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Motion of all disks together, on top of the shear flow:
///
///     u = sum m dv / sum m,    dv = v - gammadot y x^.
///
/// Pair forces and images that cross y = 0 or L_y do not change u_y, and change u_x by -u_y in a
/// unit of strain. A run therefore keeps the mean motion of its start, and its p_kin contains m
/// u^2/2 of each disk.
struct MeanMotion {
  std::array<double, 2> velocity;  ///< u, [d_s / tau_e]
  double share;  ///< sum m u^2 / sum m dv^2; 0 where no disk moves against the flow
};

/// Mean motion with the masses of the scene and the strain rate of the state, or the scene's if the
/// state has none.
MeanMotion mean_motion(State const& state, Scene const& scene);

/// True if a mean motion is more than rounding: relative to rate d_s, which is the scale of dv in a
/// flow, and to the last digit of a position in a box of this height, in a tau_e. It is of the
/// latter size in a packing that came to rest after it flew faster.
bool is_more_than_rounding(MeanMotion const& motion, double rate, double height);

/// Subtracts u from all velocities. Changes no bit, and returns nothing, if u is rounding, or
/// relative to dv.
std::optional<MeanMotion> take_off_mean_motion(State& state, Scene const& scene);

}  // namespace bagnold
