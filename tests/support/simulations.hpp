// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "src/config/scene_physics.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/start/relax_overlaps.hpp"
#include "src/start/start.hpp"
#include "tests/reference/reference.hpp"
#include "tests/support/reference_law.hpp"
#include "tests/support/schemes.hpp"

/// Scenes, starts and comparisons that the tests of simulations share.
namespace bagnold::test {

/// The names in the one list of laws.
inline std::vector<std::string> law_names() {
  return []<class... L>(std::tuple<L...> const*) {
    return std::vector<std::string>{std::string(L::name)...};
  }(static_cast<Laws const*>(nullptr));
}

/// A small system under fast shear, with the papers' scheme: many contacts, rebuilds and crossings
/// in a few hundred steps.
inline Scene small_scene(std::string const& model, double packing_fraction = 0.82,
                         std::int64_t count = 64) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.count = count;
  scene.disks.packing_fraction = packing_fraction;
  scene.disks.elasticity = 2.0;
  scene.disks.mass = "area";
  if (model == "CD_nt") {
    scene.disks.damping_normal = 0.7;
    scene.disks.damping_tangential = 1.6;
  }
  scene.shear.strain_rate = 1e-2;
  scene.shear.strain = 1.0;
  scene.start.iterations = 3000;
  scene.integration.scheme = papers_scheme;
  scene.integration.time_step = 0.05;
  scene.integration.skin = 0.1;
  return scene;
}

/// Makes the scene a ramp from 5e-3 to 1e-2 whose rate changes every five steps.
inline void ramp_every_five_steps(Scene& scene) {
  auto& shear = scene.shear;
  shear.protocol = "ramp";
  shear.ramp_every = 5 * scene.integration.time_step.number.value();
  shear.ramp_window = 10 * shear.ramp_every;
  shear.ramp_rate = 0.01 / shear.ramp_every;
  shear.strain_rate = 5e-3;
  shear.strain_rate_high = 1e-2;
}

/// A test runs once for every (law, backend, engine); devices have the reference engine alone.
class EverySimulation
    : public testing::TestWithParam<std::tuple<std::string, std::string, std::string>> {
 public:
  std::string law() const { return std::get<0>(GetParam()); }
  std::string backend() const { return std::get<1>(GetParam()); }
  std::string engine() const { return std::get<2>(GetParam()); }

  /// A small system under fast shear, with the papers' scheme.
  Scene small_scene(double packing_fraction = 0.82, std::int64_t count = 64) const {
    Scene scene = test::small_scene(law(), packing_fraction, count);
    scene.integration.engine = engine();
    return scene;
  }

  static auto all() {
    std::vector<ParamType> all;
    for (auto const& law : law_names())
      for (auto const& backend : backend_names())
        for (std::string const engine : {"reference", "few-contacts", "many-contacts", "lookahead"})
          if (backend != "cuda" || engine == "reference") all.emplace_back(law, backend, engine);
    return testing::ValuesIn(all);
  }
  static std::string name(testing::TestParamInfo<ParamType> const& info) {
    auto const& [law, backend, engine] = info.param;
    auto name = law + "_" + backend + "_" + engine;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

#define BAGNOLD_FOR_EVERY_SIMULATION(Suite) \
  INSTANTIATE_TEST_SUITE_P(All, Suite, Suite::all(), Suite::name)

/// A random start with the offset at a third of the box, so that rows above and below are shifted,
/// and with velocities beyond the mean flow: all drift upwards, so that some cross the edge.
inline State shaken_start(Scene const& scene) {
  State state = random_start(scene).state;
  state.offset = state.box_length / 3;
  relax_overlaps(state, scene.start.overlap, scene.start.iterations,
                 scene.integration.skin.number.value_or(usual_skin));
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const k = static_cast<double>(i);
    state.velocity[i][0] =
        scene.shear.strain_rate * state.position[i][1] + 0.02 * std::sin(12.9898 * k);
    state.velocity[i][1] += 0.1 + 0.02 * std::cos(78.233 * k);
    if (!state.spin.empty()) state.spin[i] += 0.02 * std::sin(4.1 * k);
  }
  return state;
}

inline std::unique_ptr<Simulation> simulate(Scene const& scene, State const& state,
                                            std::string const& backend) {
  return make_simulation(scene, first_snapshot(state), backend);
}

/// Steps on, evaluating every so many, to the end of a run of that length.
inline WindowSums advance(Simulation& simulation, std::int64_t steps,
                          std::int64_t every = std::int64_t{1} << 40) {
  Sampling sampling;
  sampling.every = every;
  sampling.last_step = simulation.step() + steps;
  OpenWindows windows;
  simulation.advance(steps, sampling, windows);
  return windows.take_first();
}

/// Throws reference::NoFormula where the reference has not the law.
inline reference::Parameters reference_parameters(Scene const& scene) {
  reference::Parameters p;
  set_law(p, scene.disks);
  p.force_exponent = scene.disks.force_exponent;
  p.area_mass = scene.mass_by_area();
  p.strain_rate = scene.shear.strain_rate;
  p.time_step = time_step(scene);
  return p;
}

/// Largest difference of two states of one system, whichever images their disks are at:
/// positions [d_s], velocities [d_s/tau_e] and spins [1/tau_e] alike.
inline double largest_difference(State const& a, State const& b, double strain_rate) {
  double const length = a.box_length, height = a.box_height();
  double largest = 0.0;
  auto const see = [&](double difference) {
    if (!(std::abs(difference) <= largest)) largest = std::abs(difference);
  };
  for (std::size_t i = 0; i < a.count(); ++i) {
    double dy = a.position[i][1] - b.position[i][1];
    double const n = std::round(dy / height);
    dy -= n * height;
    double dx = a.position[i][0] - b.position[i][0] - n * a.offset;
    dx -= std::round(dx / length) * length;
    see(dx);
    see(dy);
    see(a.velocity[i][0] - b.velocity[i][0] - n * strain_rate * height);
    see(a.velocity[i][1] - b.velocity[i][1]);
    if (!a.spin.empty()) see(a.spin[i] - b.spin[i]);
  }
  return largest;
}

/// Steps on, and holds state and sums against those of the reference engine from the same start.
inline void expect_the_reference_engines(Simulation& simulation, Scene scene, State const& start,
                                         std::int64_t steps) {
  scene.integration.engine = "reference";
  auto const oracle = simulate(scene, start, backend_names().front());
  auto const sums = advance(simulation, steps, 50);
  auto const expected = advance(*oracle, steps, 50);
  EXPECT_LT(largest_difference(simulation.state(), oracle->state(), scene.shear.strain_rate),
            1e-12);
  for (int c = 0; c < simulation.columns(); ++c)
    EXPECT_NEAR(sums.sums[c], expected.sums[c], 1e-10 * (1 + std::abs(expected.sums[c]))) << c;
}

}  // namespace bagnold::test
