// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/ladder.hpp"

#include <gtest/gtest.h>

#include "src/config/plan.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {
namespace {

Scene laddered(std::string const& model, double elasticity = 1) {
  Scene scene;
  scene.disks = {.model = model,
                 .count = 256,
                 .packing_fraction = 0.82,
                 .elasticity = elasticity,
                 .mass = "equal"};
  scene.shear.strain_rate = 1e-4;
  scene.integration.scheme = automatic;
  return scene;
}

using Methods = std::vector<Method>;
constexpr char implicit[] = "implicit-damping";

/// The cheapest first, unstable steps and collisions that lose too much or too little left out.
TEST(Ladder, MethodsByTheirCost) {
  EXPECT_EQ(ladder_of(laddered("CD")).methods,
            (Methods{{implicit, 8}, {default_scheme, 2}, {implicit, 4}, {default_scheme}}));
  EXPECT_EQ(ladder_of(laddered("CD_rot")).methods, (Methods{{implicit, 9}, {default_scheme}}));
  EXPECT_EQ(ladder_of(laddered("CD_n")).methods, (Methods{{default_scheme, 2}, {default_scheme}}));
  EXPECT_EQ(ladder_of(laddered("CD_n", 50)).methods, (Methods{{default_scheme}}));
  EXPECT_EQ(ladder_of(laddered("CD", 10)).methods, (Methods{{implicit, 4}, {default_scheme}}));
  EXPECT_EQ(ladder_of(laddered("CD", 200)).methods, (Methods{{default_scheme}}));
}

TEST(Ladder, FinerOnesWhereTheyAreAskedFor) {
  auto const finer = [](Scene const& scene) {
    auto const ladder = ladder_of(scene);
    return ladder.methods.size() - ladder.usual - 1;
  };
  Scene scene = laddered("CD_n", 50);
  EXPECT_EQ(finer(scene), 0U);
  scene.measure.bias = true;
  EXPECT_EQ(finer(scene), 4U);
  scene.measure.bias = false;
  scene.integration.accuracy = 1e-3;
  EXPECT_EQ(finer(scene), 4U);
  EXPECT_EQ(with_method(scene, ladder_of(scene).methods.back()).integration.time_step.number,
            0.2 / 16);
}

TEST(Ladder, NothingToChoose) {
  auto const unsuited = [&](auto const& change) {
    Scene scene = laddered("CD");
    change(scene);
    EXPECT_FALSE(may_change_method(scene));
    EXPECT_NE(resolved(scene).integration.scheme, automatic);
  };
  unsuited([](Scene& s) { s.integration.scheme = default_scheme; });
  unsuited([](Scene& s) { s.measure.contacts = true; });
  unsuited([](Scene& s) {
    s.shear.protocol = "ramp";
    s.shear.strain_rate_high = 1e-3;
    s.shear.ramp_rate = 1e-5;
  });
  unsuited([](Scene& s) { s.drive.kind = "stokes"; });
  unsuited([](Scene& s) { s.integration.time_step = of_papers; });
  for (double const dt : {0.4, 1.0})  // longer than the rule: kept
    unsuited([&](Scene& s) { s.integration.time_step = dt; });
  EXPECT_EQ(resolved(laddered("CD")).integration.scheme, automatic);
}

/// Frames may be measured; steps are then no longer than between two of them.
TEST(Ladder, WithFrames) {
  Scene scene = laddered("CD_rot");
  for (bool Scene::Measure::*one : {&Scene::Measure::fields, &Scene::Measure::rotation}) {
    scene.measure = {};
    scene.measure.*one = true;
    EXPECT_EQ(ladder_of(scene).methods, ladder_of(laddered("CD_rot")).methods);
    scene.measure.frame_strain = 1.5 * time_step(scene) * scene.shear.strain_rate;
    EXPECT_FALSE(may_change_method(scene));
  }
}

/// Windows hold whole steps of every method, places of changes whole windows, and so does the run.
TEST(Ladder, WholeSteps) {
  for (double const rate : {1e-2, 1e-3, 3e-5}) {
    Scene scene = laddered("CD_rot");
    scene.shear.strain_rate = rate;
    scene.shear.strain = 1.2345;
    scene.output.trajectory_strain = 0.0321;
    auto const ladder = ladder_of(scene);
    auto const plan = make_plan(scene);
    EXPECT_EQ(plan.window_steps, ladder.window);
    EXPECT_EQ(plan.window_steps % 9, 0);
    EXPECT_EQ(ladder.grid % ladder.window, 0);
    EXPECT_GE(static_cast<double>(ladder.grid) * plan.time_step * rate, 0.03 * (1 - 1e-9));
    EXPECT_EQ(plan.steps % plan.window_steps, 0);
    EXPECT_EQ(plan.frame_steps % ladder.whole, 0);
    EXPECT_EQ(plan.trajectory_steps % ladder.whole, 0);
    EXPECT_GT(plan.trajectory_steps, 0);
    EXPECT_LT(plan.strain(plan.steps - plan.window_steps), scene.shear.strain.at(0));
  }
}

/// Stretches of less strain at small rates, and windows that make thirds of them.
TEST(Ladder, StretchesAtSmallRates) {
  auto const stretch = [](Scene scene, double rate) {
    scene.shear.strain_rate = rate;
    auto const ladder = ladder_of(scene);
    double const step = time_step(scene) * rate;
    EXPECT_TRUE(ladder.shares) << rate;
    EXPECT_NEAR(static_cast<double>(ladder.grid) * step, ladder.stretch, 0.1 * ladder.stretch);
    EXPECT_EQ(make_plan(scene).window_steps, ladder.window);
    return ladder.stretch;
  };
  for (auto const* model : {"CD", "CD_rot"}) {
    auto scene = laddered(model);
    for (double const rate : {1e-4, 1e-5}) EXPECT_EQ(stretch(scene, rate), 0.03);
    EXPECT_DOUBLE_EQ(stretch(scene, 5e-6), 0.015);
    for (double const rate : {2e-6, 1e-6, 1e-7}) EXPECT_EQ(stretch(scene, rate), 0.0075);
    scene.disks.packing_fraction = 0.78;
    EXPECT_NEAR(stretch(scene, 1e-6), 0.0199, 1e-4) << "half of a gap";
    scene.disks.packing_fraction = 0.7;
    EXPECT_EQ(stretch(scene, 1e-6), 0.03);
    scene.disks.packing_fraction = 0.86;
    EXPECT_EQ(stretch(scene, 1e-6), 0.0075);
    scene.integration.accuracy = 1e-3;
    EXPECT_EQ(ladder_of(scene).stretch, 0.03);
  }
  EXPECT_EQ(stretch(laddered("CD_n"), 1e-6), 0.03) << "no method damps all";
}

/// Frames as near each other as they are asked for.
TEST(Ladder, NoStepsLongerThanBetweenFrames) {
  auto scene = laddered("CD");
  scene.output.trajectory_strain = 1e-4;  // five steps of two stages
  auto const ladder = ladder_of(scene);
  EXPECT_EQ(ladder.methods, (Methods{{default_scheme, 2}, {implicit, 4}, {default_scheme}}));
  EXPECT_EQ(make_plan(scene).trajectory_steps, 8);
  scene.output.trajectory_strain = 3e-5;
  EXPECT_FALSE(may_change_method(scene));
}

/// Steps of a strain of 2e-4 where they pay: creep of few disks without spins.
TEST(Ladder, QuasiStaticStepsWhereTheyPay) {
  auto const first = [](Scene const& scene) { return ladder_of(scene).methods.front(); };
  auto scene = laddered("CD");
  scene.disks.count = 1024;
  scene.shear.strain_rate = 2.1e-7;
  EXPECT_EQ(first(scene), (Method{"backward-euler", 4760}));  // whole ones of 8
  EXPECT_EQ(ladder_of(scene).window % 4760, 0);
  auto const method = with_method(scene, first(scene));
  EXPECT_TRUE(is_quasi_static(method));
  EXPECT_EQ(time_step(method), 4760 * 0.2);
  auto const unsuited = [&](auto change) {
    auto other = scene;
    change(other);
    EXPECT_NE(first(other).scheme, backward_euler);
  };
  unsuited([](Scene& s) { s.shear.strain_rate = 1.4e-6; });
  unsuited([](Scene& s) { s.disks.model = "CD_rot"; });
  unsuited([](Scene& s) { s.disks.count = 8192; });
  unsuited([](Scene& s) { s.integration.engine = "steps"; });
  unsuited([](Scene& s) { s.integration.accuracy = 0.009; });
  unsuited([](Scene& s) { s.measure.profiles = true; });
  unsuited([](Scene& s) { s.disks.elasticity = 2; });
  unsuited([](Scene& s) { s.disks.force_exponent = 2.5; });
}

/// Two stages where a run is too short to gain, or a step is named, or nothing else is there.
TEST(Ladder, TakenWhereNothingIsNamed) {
  auto scene = laddered("CD");
  scene.shear.strain = 4;
  EXPECT_TRUE(auto_is_default(scene));
  scene.shear.strain = 3.99;
  EXPECT_FALSE(auto_is_default(scene));
  scene.integration.accuracy = 0.009;
  EXPECT_TRUE(auto_is_default(scene));
  scene.integration.time_step = 0.1;
  EXPECT_FALSE(auto_is_default(scene));
  scene = laddered("CD_n", 50);
  scene.shear.strain = 4;
  EXPECT_FALSE(auto_is_default(scene));
}

/// A run shorter than a window is not made as long as one: it is refused.
TEST(Ladder, LessThanAWindow) {
  Scene scene = laddered("CD");
  scene.shear.strain = 0.05;
  scene.output.sample_strain = 1;
  auto const plan = make_plan(scene);
  EXPECT_LT(plan.steps, plan.window_steps);
}

/// What is discarded is a share of what is left when a method is left.
TEST(Ladder, WindowsThatAreDropped) {
  Scene scene = laddered("CD");
  scene.shear.strain = 2;
  scene.shear.discard = 0.5;
  Plan plan = make_plan(scene);
  auto const windows = plan.windows;
  for (std::int64_t const dropped : {std::int64_t{0}, windows / 4, windows, windows + 7}) {
    plan.dropped_windows = dropped;
    auto const left = windows - std::min(dropped, windows);
    EXPECT_EQ(shortened(scene, plan, windows).discarded_windows, windows - left / 2) << dropped;
  }
}

}  // namespace
}  // namespace bagnold
