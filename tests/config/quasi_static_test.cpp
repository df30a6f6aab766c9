// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/quasi_static.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "src/config/cascade.hpp"
#include "src/config/plan.hpp"
#include "src/config/stability.hpp"
#include "src/config/time_step.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

std::string const creeping_text = disks_text + R"([shear]
strain_rate = 1e-6
strain = 20.0
[integration]
engine = "quasi-static"
)";

TEST(QuasiStaticScenes, AreSteppedByAStrain) {
  Scene const scene = parse(creeping_text);
  EXPECT_EQ(scheme_of(scene), backward_euler);
  EXPECT_DOUBLE_EQ(time_step(scene), 1000);
  EXPECT_DOUBLE_EQ(time_step(parse(creeping_text, {"integration.time_step=300"})), 300);
  Plan const plan = make_plan(scene);
  EXPECT_EQ(plan.steps, 20000);
  EXPECT_EQ(plan.window_steps, 10);
  EXPECT_EQ(plan.every, 1);
  check_feasible(scene, plan, false);
  EXPECT_EQ(largest_stable_time_step(scene, backward_euler),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(dense_flow_time_step(scene, backward_euler), std::numeric_limits<double>::infinity());
}

TEST(QuasiStaticScenes, AreReadAgainAsTheyAreResolved) {
  Scene const scene = resolved(parse(creeping_text));
  EXPECT_EQ(scene.integration.scheme, backward_euler);
  EXPECT_EQ(scene.integration.time_step, NumberOrWord(1000));
  Scene const again = parse(write_scene(scene));
  EXPECT_EQ(write_scene(again), write_scene(scene));
}

/// Each rate has a step of its own.
TEST(QuasiStaticScenes, CascadesStepEachRateByAStrain) {
  Scene const cascade = resolved(parse(
      cascade_text, {"integration.engine=quasi-static", "shear.strain_rates=[1e-5, 1e-6, 1e-7]"}));
  EXPECT_DOUBLE_EQ(time_step(stage_of(cascade, 0, "")), 100);
  EXPECT_DOUBLE_EQ(time_step(stage_of(cascade, 2, "")), 1e4);
}

TEST(QuasiStaticScenes, AreRefusedWhereTheyMeanNothing) {
  struct Case {
    std::vector<std::string> overrides;
    std::string part;
  };
  for (auto const& [overrides, part] : std::vector<Case>{
           {{"integration.scheme=implicit-damping"},
            "steps by \"backward-euler\", not by integration.scheme = \"implicit-damping\""},
           {{"drive.kind=stokes", "drive.drag=1"}, "no part for drive.kind = \"stokes\""},
           {{"disks.force_exponent=2.5"}, "disks.force_exponent = 2, here it is 2.5"},
           {{"measure.contacts=true"}, "set measure.contacts = false"},
           {{"measure.profiles=true"}, "set measure.profiles = false"},
           {{"disks.count=4098"}, "disks.count = 4098"},
           {{"shear.strain_rate=2e-5"}, "up to a rate of 1e-05: at 2e-05"},
           {{"integration.time_step=paper"}, "integration.time_step = \"paper\""},
           {{"integration.time_step=20000"}, "is a strain of 0.02"}}) {
    auto const message = refusal(creeping_text, overrides);
    EXPECT_TRUE(has(message, "integration.engine = \"quasi-static\"")) << message;
    EXPECT_TRUE(has(message, part)) << message;
  }
  EXPECT_EQ(refusal(creeping_text, {"disks.count=4096", "shear.strain_rate=1e-5"}), "accepted");
  EXPECT_TRUE(has(refusal(ramp_text, {"integration.engine=quasi-static"}),
                  "shear.protocol = \"ramp\" goes by time"));
}

TEST(QuasiStaticScenes, OtherEnginesHaveNeitherItsSchemeNorItsSteps) {
  EXPECT_TRUE(
      has(refusal(minimal_text, {"integration.scheme=backward-euler"}),
          "is stepped by integration.engine = \"quasi-static\" alone, here it is \"auto\""));
  EXPECT_TRUE(has(refusal(minimal_text, {"integration.time_step=11"}),
                  "integration.time_step = 11 (must be at most 10"));
}

}  // namespace
}  // namespace bagnold
