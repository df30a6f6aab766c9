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
/// Pair forces and images that cross y = 0 or L_y leave u_y as it is, and change u_x by -u_y in a
/// unit of strain. So a run keeps what its start has of it, and its p_kin holds m u^2/2 of each
/// disk.
struct MeanMotion {
  std::array<double, 2> velocity;  ///< u, [d_s / tau_e]
  double share;  ///< sum m u^2 / sum m dv^2; 0 where no disk moves against the flow
};

/// With the masses of the scene and the strain rate of the state, the scene's where it has none.
MeanMotion mean_motion(State const& state, Scene const& scene);

/// Takes u off all velocities. Changes no bit, and gives nothing, where u is rounding: beside dv,
/// or beside gammadot d_s, which is what disks of a flow have against it.
std::optional<MeanMotion> take_off_mean_motion(State& state, Scene const& scene);

}  // namespace bagnold
