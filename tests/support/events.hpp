// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/config/events.hpp"
#include "src/engine/events/event_engine.hpp"
#include "tests/support/simulations.hpp"

/// Dilute scenes, starts and comparisons that the tests of events share.
namespace bagnold::test {

inline constexpr double slow_rate = 1e-4;  ///< [1/tau_e]

inline Scene dilute_scene(std::string const& model, double packing_fraction = 0.70,
                          std::int64_t count = 64, double elasticity = 20) {
  Scene scene = small_scene(model, packing_fraction, count);
  scene.disks.elasticity = elasticity;
  scene.shear.strain_rate = slow_rate;
  scene.integration.scheme = automatic;
  scene.integration.engine = event_engine;
  scene.integration.time_step = automatic;
  scene.integration.skin = 0.35;
  return scene;
}

/// Makes the scene a ramp from 1e-4 to 4e-4 and back, by 6% a time unit.
inline void ramp_by_time_units(Scene& scene) {
  scene.start.kind = "state";
  auto& shear = scene.shear;
  shear.protocol = "ramp";
  shear.strain_rate_high = 4 * slow_rate;
  shear.ramp_rate = 0.025;
  shear.ramp_every = 1;
  shear.ramp_window = 6;
  shear.strain = 3 * slow_rate;
}

/// Disks that fly past each other at a few times the rate, some of which overlap a little.
inline State flying_start(Scene const& scene) {
  State state = shaken_start(scene);
  double const rate = scene.shear.strain_rate;
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const k = static_cast<double>(i);
    state.velocity[i] = {rate * (state.position[i][1] + 4 * std::sin(12.9898 * k)),
                         4 * rate * std::cos(78.233 * k)};
    if (!state.spin.empty()) state.spin[i] = rate * std::sin(4.1 * k);
  }
  return state;
}

/// The engine in steps of a plain one.
inline Scene in_steps(Scene scene, double time_step) {
  scene.integration.engine = "many-contacts";
  scene.integration.scheme = papers_scheme;
  scene.integration.time_step = time_step;
  return scene;
}

/// On one thread.
inline std::unique_ptr<Simulation> simulate_events(Scene const& scene, State const& state) {
  return simulate(scene, state, "serial");
}

/// Shortest image of a difference of two positions, [d_s].
inline std::array<double, 2> nearest_image(State const& box, double dx, double dy) {
  double const n = std::round(dy / box.box_height());
  dy -= n * box.box_height();
  dx -= n * box.offset;
  return {dx - std::round(dx / box.box_length) * box.box_length, dy};
}

/// Distance of the disks of two states in the mean square, [d_s].
inline double distance_between(State const& a, State const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.count(); ++i) {
    auto const [dx, dy] =
        nearest_image(a, a.position[i][0] - b.position[i][0], a.position[i][1] - b.position[i][1]);
    sum += dx * dx + dy * dy;
  }
  return std::sqrt(sum / static_cast<double>(a.count()));
}

/// All that overlap, all pairs, and by how much, [d_s].
inline std::map<std::pair<std::uint32_t, std::uint32_t>, double> overlapping_pairs(
    Scene const& scene, State const& state) {
  reference::System const all(reference_parameters(scene), state);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> found;
  for (auto const& c : reference::contacts(all)) {
    double const d = (state.diameter[c.i] + state.diameter[c.j]) / 2;
    auto const i = static_cast<std::uint32_t>(std::min(c.i, c.j));
    auto const j = static_cast<std::uint32_t>(std::max(c.i, c.j));
    found[{i, j}] = d - std::hypot(c.x, c.y);
  }
  return found;
}

/// r_ij - d_ij of the nearest image, [d_s].
inline double gap_of(State const& s, std::uint32_t i, std::uint32_t j) {
  auto const [dx, dy] =
      nearest_image(s, s.position[i][0] - s.position[j][0], s.position[i][1] - s.position[j][1]);
  return std::sqrt(dx * dx + dy * dy) - (s.diameter[i] + s.diameter[j]) / 2;
}

/// Kinetic energy of what leaves the mean flow, and elastic energy of contacts.
inline double stored_energy(Scene const& scene, State const& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const u = state.velocity[i][0] - slow_rate * state.position[i][1],
                 v = state.velocity[i][1];
    sum += disk_mass(true, state.diameter[i]) * (u * u + v * v) / 2;
    if (scene.rotates())
      sum += disk_inertia(true, state.diameter[i]) * state.spin[i] * state.spin[i] / 2;
  }
  for (auto const& [pair, overlap] : overlapping_pairs(scene, state)) {
    double const d = (state.diameter[pair.first] + state.diameter[pair.second]) / 2;
    sum += overlap * overlap / (2 * d * d);
  }
  return sum;
}

/// Work less what is dissipated and stored, over what is dissipated. sums: between the two states.
inline double energy_gap(Scene const& scene, State const& before, std::vector<double> const& sums,
                         State const& after) {
  using C = SumColumns;
  double const dt = time_step(scene);
  double const work =
      -slow_rate * (sums[C::elastic_xy] + sums[C::dissipative_xy] + sums[C::kinetic_xy]) * dt;
  double const lost = sums[C::dissipation] * dt;
  return (work - lost - (stored_energy(scene, after) - stored_energy(scene, before))) / lost;
}

/// All that the events know to touch now, i < j.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> known_contacts(
    Simulation const& simulation, bool rotates) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  auto const collect = [&](auto const& engine) {
    for (auto const& pair : events::touching_pairs(engine.all(), engine.now()))
      found.emplace_back(pair.i, pair.j);
  };
  if (rotates)
    collect(dynamic_cast<EventEngine<true> const&>(simulation));
  else
    collect(dynamic_cast<EventEngine<false> const&>(simulation));
  return found;
}

}  // namespace bagnold::test
