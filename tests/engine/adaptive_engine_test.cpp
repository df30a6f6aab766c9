// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/abilities.hpp"
#include "src/config/errors.hpp"
#include "src/config/events.hpp"
#include "tests/support/events.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

Scene adaptive_scene(double packing_fraction, double rate, double elasticity) {
  Scene scene = small_scene("CD_n", packing_fraction, 100);
  scene.disks.elasticity = elasticity;
  scene.shear.strain_rate = rate;
  scene.integration.scheme = automatic;
  scene.integration.engine = adaptive_engine;
  scene.integration.time_step = automatic;
  return scene;
}

constexpr std::int64_t adaptive_window = 500, adaptive_end = 20000;

double by_events(Simulation const& simulation) {
  return simulation.snapshot().counters.at("steps_by_events");
}

}  // namespace

TEST(AdaptiveEngine, TakesEventsWhereDisksFlyAndStepsWhereTheyTouch) {
  Scene const dilute = adaptive_scene(0.6, 1e-4, 20), dense = adaptive_scene(0.84, 1e-3, 1);
  auto const run = [](Scene const& scene) {
    auto simulation = test::simulate(scene, flying_start(scene), "serial");
    OpenWindows windows;
    simulation->advance(adaptive_end, {adaptive_window, 10, adaptive_end}, windows);
    for (auto const& of : windows.sums) EXPECT_NEAR(of.weight, adaptive_window / 10, 1e-9);
    return simulation;
  };
  EXPECT_EQ(by_events(*run(dilute)),
            adaptive_end - adaptive_window);  // a window of steps tells how many touch
  EXPECT_EQ(by_events(*run(dense)), 0);
}

/// Steps, events, steps and so on: contacts of Q = 1 gather in clusters.
TEST(AdaptiveEngine, BitsDoNotDependOnCutsOrRestarts) {
  Scene const scene = adaptive_scene(0.7, 1e-4, 1);
  State const start = flying_start(scene);
  auto const straight = test::simulate(scene, start, "serial");
  auto chained = test::simulate(scene, start, "serial");
  Sampling const sampling{adaptive_window, 10, adaptive_end};
  OpenWindows a, b;
  straight->advance(adaptive_end, sampling, a);
  for (int k = 0; chained->step() < adaptive_end; ++k) {
    chained->advance(1 + 97 * (k % 5), sampling, b);
    chained = make_simulation(scene, chained->snapshot(), "serial");
  }
  EXPECT_GT(by_events(*straight), 0);
  EXPECT_LT(by_events(*straight), adaptive_end - adaptive_window);
  EXPECT_EQ(straight->state().position, chained->state().position);
  EXPECT_EQ(straight->state().velocity, chained->state().velocity);
  EXPECT_EQ(straight->snapshot().memory, chained->snapshot().memory);
  EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
  ASSERT_EQ(a.sums.size(), b.sums.size());
  for (std::size_t w = 0; w < a.sums.size(); ++w) {
    EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << w;
    EXPECT_EQ(a.sums[w].weight, b.sums[w].weight) << w;
  }
}

TEST(AdaptiveEngine, RefusesWhatEventsCannotDo) {
  Scene scene = adaptive_scene(0.6, 1e-4, 20);
  EXPECT_TRUE(why_not(scene).empty());
  scene.measure.contacts = true;
  scene.disks.force_exponent = 2.5;
  auto const refused = why_not(scene);
  ASSERT_EQ(refused.size(), 2u);
  for (auto const& one : refused)
    EXPECT_NE(one.message.find("engine = \"adaptive\""), std::string::npos) << one.message;
  EXPECT_THROW(test::simulate(scene, flying_start(scene), "serial"), InputError);
}

}  // namespace bagnold::test
