// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/validate_scene.hpp"

#include <gtest/gtest.h>

#include "src/config/errors.hpp"
#include "src/config/events.hpp"

namespace bagnold {
namespace {

Scene scene_with(std::int64_t count, double skin) {
  Scene scene;
  scene.disks = {"CD_n", count, 0.82, 1.0, "area"};
  scene.shear.strain_rate = 1e-3;
  scene.shear.strain = 1.0;
  scene.integration.skin = skin;
  return scene;
}

/// What it is refused for, or "".
std::string refusal(Scene const& scene) {
  try {
    validate_scene(scene, make_plan(scene), false);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

/// 1.3e2 pairs a disk, of 2^32 in all; whatever memory the machine has.
TEST(ValidateScene, RefusesMorePairsThanListsCanName) {
  auto const said = refusal(scene_with(40'000'000, 10.0));
  for (auto const* word :
       {"disks.count = 40000000 with integration.skin = 10", "pairs", "fewer disks"})
    EXPECT_NE(said.find(word), std::string::npos) << said;
  Scene plain = scene_with(40'000'000, 10.0);
  plain.integration.engine = "reference";
  for (auto const& scene : {scene_with(40'000'000, 0.35), scene_with(20'000'000, 10.0), plain})
    EXPECT_EQ(refusal(scene).find("pairs"), std::string::npos) << refusal(scene);
}

/// A leg of whole windows: one window of 1000 tau_e would be ten decades.
TEST(ValidateScene, RefusesRampsThatPassTheirTop) {
  Scene scene = scene_with(64, 0.35);
  auto& shear = scene.shear;
  shear.protocol = "ramp";
  shear.strain_rate = 1e-4;
  shear.strain_rate_high = 1e-2;
  shear.ramp_rate = 1e-2;
  auto const said = refusal(scene);
  for (auto const* words :
       {"shear.ramp_window = 1000 (a ramp is whole windows long, so it goes to 1e+06",
        "take at most 25,"})
    EXPECT_NE(said.find(words), std::string::npos) << said;
  shear.ramp_window = 20;
  EXPECT_EQ(refusal(scene), "");
}

TEST(ValidateScene, RefusesLongTimeUnitsOfEvents) {
  Scene scene = scene_with(64, 0.35);
  scene.disks.elasticity = 20;
  scene.integration.engine = event_engine;
  scene.integration.time_step = 1;
  EXPECT_EQ(refusal(scene), "");
  scene.integration.time_step = 1.5;
  EXPECT_NE(refusal(scene).find("must be at most 1 with integration.engine"), std::string::npos)
      << refusal(scene);
}

}  // namespace
}  // namespace bagnold
