// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/strain_rates.hpp"
#include "src/start/deep_overlaps.hpp"
#include "src/start/random_pair.hpp"
#include "src/start/relax_overlaps.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// Nudge of disks on a lattice: without it they push each other along its rows for ever.
constexpr double nudge = 1e-6;  // [d_s]

void leave_symmetry(State& state, std::int64_t seed) {
  for (std::size_t i = 0; i < state.count(); ++i) {
    auto const random = random_pair(seed, i, Purpose::nudge);
    for (int c : {0, 1}) state.position[i][c] += nudge * (2 * random[c] - 1);
  }
}

}  // namespace

void relax_state(StartedState& started, Scene const& scene, std::function<bool()> const& go_on) {
  State& state = started.state;
  State at_rest = state;
  at_rest.velocity.clear();
  at_rest.spin.clear();
  if (deep_overlaps(state, scene.start.overlap).pairs > 0)
    leave_symmetry(at_rest, scene.disks.seed);
  relax_start(at_rest, scene, scene.start.file, started.record, go_on);
  for (std::size_t i = 0; i < state.count(); ++i)
    state.velocity[i][0] += first_rate(scene) * (at_rest.position[i][1] - state.position[i][1]);
  state.position = std::move(at_rest.position);
}

}  // namespace bagnold
