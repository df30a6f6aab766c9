// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/start/mean_motion.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// A first state and its history, for the record.
struct StartedState {
  State state;
  std::map<std::string, double> record;
  std::optional<MeanMotion> mean_motion = {};  ///< that was subtracted, if any
};

// Names in `record` of the mean motion that was subtracted; all replicas have them if one had any.
inline constexpr char start_mean_velocity_x[] = "start_mean_velocity_x";
inline constexpr char start_mean_velocity_y[] = "start_mean_velocity_y";
inline constexpr char start_mean_motion_share[] = "start_mean_motion_share";

/// Random positions (Philox keyed by seed, counted by disk: independent of backend and threads),
/// for many disks without long waves of the density (even_out). Overlaps are relaxed, then v =
/// gammadot y x^ and thetadot = -gammadot/2. Disks 0 .. N/2 - 1 are small.
///
/// Above jamming overlaps remain: recorded as `start_overlap`. Throws NumericalError above 5%, and
/// StartStopped if go_on, asked now and then, returns false. Kokkos must run.
StartedState random_start(
    Scene const& scene, std::function<bool()> const& go_on = [] { return true; });

/// True if a relaxation is limited by long waves and memory. Smaller starts keep the bits of the
/// first version.
inline bool is_large(State const& state) { return state.count() >= 8192; }

/// Relative overlap that a relaxation may leave.
inline constexpr double largest_start_overlap = 0.05;

/// Pushes the overlapping disks of a state from elsewhere apart, as for a random start. Velocities
/// relative to the mean flow and spins stay unchanged. Recorded as `start_iterations` and
/// `start_overlap`. Throws NumericalError if more than largest_start_overlap is left, and
/// StartStopped if go_on returns false. Kokkos must run.
void relax_state(
    StartedState& started, Scene const& scene,
    std::function<bool()> const& go_on = [] { return true; });

/// States of a file, one for each of the scene's replicas. Throws InputError if they disagree with
/// the scene, are more or fewer than its replicas, or two are equal: those would run alike, and
/// errors over replicas would be too small. With start.copies each is first copied side by side. If
/// a state was made at another strain rate, its velocities and spins are scaled (P2 Eqs. 40-41).
/// Then the motion of all disks together on top of the shear flow is subtracted, which a run would
/// keep (mean_motion.hpp). All else is unchanged.
std::vector<StartedState> fit_to_scene(std::vector<State> states, Scene const& scene);

}  // namespace bagnold
