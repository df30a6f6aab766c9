// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>

#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// A first state and what is to be known about how it came about, for the record.
struct StartedState {
  State state;
  std::map<std::string, double> record;
};

/// Random positions (Philox keyed by seed, counted by disk: independent of backend and threads),
/// overlaps relaxed, then v = gammadot y x^ and thetadot = -gammadot/2. Disks 0 .. N/2 - 1 are small.
///
/// Above jamming overlaps remain: recorded as `start_overlap`. Throws NumericalError above 5%.
/// Kokkos must run.
StartedState random_start(Scene const& scene);

/// A state from a file, taken as it is; throws InputError where it disagrees with the scene.
/// Made at another strain rate, its velocities and spins are scaled (P2 Eqs. 40-41).
StartedState fit_to_scene(State state, Scene const& scene);

}  // namespace bagnold
