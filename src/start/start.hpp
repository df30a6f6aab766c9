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

/// A first state and what is to be known about how it came about, for the record.
struct StartedState {
  State state;
  std::map<std::string, double> record;
  std::optional<MeanMotion> mean_motion = {};  ///< that was taken off; none: there was none
};

// Names of `record` for it, of all replicas where one had any.
inline constexpr char start_mean_velocity_x[] = "start_mean_velocity_x";
inline constexpr char start_mean_velocity_y[] = "start_mean_velocity_y";
inline constexpr char start_mean_motion_share[] = "start_mean_motion_share";

/// Random positions (Philox keyed by seed, counted by disk: independent of backend and threads), of
/// many disks without long waves of the density (even_out), overlaps relaxed, then v = gammadot y
/// x^ and thetadot = -gammadot/2. Disks 0 .. N/2 - 1 are small.
///
/// Above jamming overlaps remain: recorded as `start_overlap`. Throws NumericalError above 5%, and
/// StartStopped when go_on, asked now and then, says no. Kokkos must run.
StartedState random_start(
    Scene const& scene, std::function<bool()> const& go_on = [] { return true; });

/// Whether long waves and memory are what a relaxation of disks waits for. The bits of smaller
/// starts are those of the first version.
inline bool is_large(State const& state) { return state.count() >= 8192; }

/// Relative overlap that a relaxation may leave.
inline constexpr double largest_start_overlap = 0.05;

/// Pushes the overlapping disks of a state apart, as those of a random start: for states from
/// elsewhere. Velocities against the mean flow and spins stay. Recorded as `start_iterations` and
/// `start_overlap`. Throws NumericalError where more than largest_start_overlap is left, and
/// StartStopped when go_on says no. Kokkos must run.
void relax_state(
    StartedState& started, Scene const& scene,
    std::function<bool()> const& go_on = [] { return true; });

/// The states of a file, one for each of the scene's replicas; throws InputError where they
/// disagree with the scene, are more or fewer than its replicas, or two are the same: those would
/// run alike, and errors over replicas would be too small. With start.copies each is set side by
/// side with itself first. Made at another strain rate, their velocities and spins are scaled (P2
/// Eqs. 40-41). Then the motion that all disks have together against the shear flow is taken off,
/// which a run would keep (mean_motion.hpp). All else is taken as it is.
std::vector<StartedState> fit_to_scene(std::vector<State> states, Scene const& scene);

}  // namespace bagnold
