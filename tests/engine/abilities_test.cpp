// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/abilities.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "src/config/errors.hpp"
#include "tests/support/events.hpp"

namespace bagnold::test {
namespace {

Scene scene_of(std::string_view engine) {
  Scene scene = small_scene("CD_rot", 0.6, 100);
  scene.disks.elasticity = 5;
  scene.integration.engine = engine;
  scene.integration.scheme = automatic;
  scene.integration.time_step = automatic;
  scene.integration.skin = automatic;
  scene.shear.strain_rate = slow_rate;
  return scene;
}

/// What an engine says it can run, it makes and advances; what it says it cannot, it refuses.
TEST(Abilities, HoldForEveryEngine) {
  std::vector<std::function<void(Scene&)>> const demands = {
      [](Scene&) {},
      [](Scene& s) { s.integration.scheme = "implicit-damping"; },
      [](Scene& s) { s.integration.time_step = of_papers; },
      [](Scene& s) { s.disks.elasticity = 0.5; },
      [](Scene& s) { s.disks.force_exponent = 2.5; },
      [](Scene& s) {
        s.drive = {"stokes", 0.1, 0};
      },
      [](Scene& s) {
        s.integration.time_step = 0.05;
        ramp_every_five_steps(s);
      },
      [](Scene& s) { s.measure.contacts = true; }};
  for (auto const& engine : all_engines())
    for (std::size_t d = 0; d < demands.size(); ++d) {
      Scene scene = scene_of(engine.engine);
      auto const start = flying_start(scene);
      demands[d](scene);
      SCOPED_TRACE(std::string(engine.engine) + ", " + std::to_string(d));
      if (!why_not(scene).empty()) {
        if (abilities_of(scene).scheme.empty()) continue;  // refused where the scene is read
        EXPECT_THROW(simulate(scene, start, "serial"), InputError);
        continue;
      }
      auto const simulation = simulate(scene, start, "serial");
      OpenWindows windows;
      simulation->advance(20, {10, 5, 20}, windows);
      EXPECT_EQ(simulation->step(), 20);
      for (auto const& v : simulation->state().velocity) EXPECT_TRUE(std::isfinite(v[0] + v[1]));
    }
}

}  // namespace
}  // namespace bagnold::test
