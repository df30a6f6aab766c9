// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "src/config/events.hpp"
#include "tests/config/scenes.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold {
namespace {

Scene scene_of(double strain, double rate, double time_step, double window, double discard) {
  Scene scene = minimal_scene();
  scene.shear.strain = strain;
  scene.shear.strain_rate = rate;
  scene.shear.discard = discard;
  scene.integration.time_step = time_step;
  scene.output.sample_strain = window;
  return scene;
}

std::string refusal_of(std::function<void()> const& action) {
  try {
    action();
  } catch (InputError const& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Plan, ExactQuotientsAreNotRoundedUp) {
  Plan const plan = make_plan(scene_of(20.0, 1e-4, 0.05, 1e-2, 0.5));
  EXPECT_EQ(plan.time_step, 0.05);
  EXPECT_EQ(plan.steps, 4'000'000);
  EXPECT_EQ(plan.window_steps, 2000);
  EXPECT_EQ(plan.windows, 2000);
  EXPECT_EQ(plan.discarded_windows, 1000);
  EXPECT_EQ(plan.every, 10);
}

/// Whatever powers of ten: strain = K rate dt in decimal is K steps, not one more.
TEST(Plan, DecimalQuotientsAreExact) {
  for (double const rate : {1e-6, 3e-5, 1e-4, 7e-3, 0.1})
    for (double const time_step : {0.01, 0.05, 0.1, 0.03})
      for (std::int64_t const steps : {1, 3, 7, 1000, 12345, 1'000'000, 999'999'999}) {
        double const strain = static_cast<double>(steps) * rate * time_step;
        EXPECT_EQ(make_plan(scene_of(strain, rate, time_step, strain, 0)).steps, steps)
            << rate << " " << time_step;
      }
}

TEST(Plan, OtherQuotientsAreRoundedUp) {
  Plan const plan = make_plan(scene_of(1.0, 0.01, 0.03, 0.1, 0.5));
  EXPECT_EQ(plan.steps, 3334);        // 1 / 0.0003 = 3333.3
  EXPECT_EQ(plan.window_steps, 334);  // 333.3
  EXPECT_EQ(plan.windows, 10);        // 9.98: the last one is shorter
  EXPECT_EQ(plan.discarded_windows, 5);
  EXPECT_EQ(make_plan(scene_of(1.0, 0.01, 0.03, 0.1, 0.51)).discarded_windows, 6);
  EXPECT_EQ(make_plan(scene_of(1.0, 0.01, 0.03, 0.1, 0.0)).discarded_windows, 0);
  EXPECT_EQ(make_plan(scene_of(1.0, 0.01, 0.03, 0.1, 0.3)).discarded_windows, 3);
  EXPECT_EQ(make_plan(scene_of(1.0, 0.01, 0.03, 0.1, 1e-9)).discarded_windows, 1);
}

TEST(Plan, CoversItsStrainInWholeSteps) {
  for (double const strain : {0.3, 1.7, 20.0 / 3, 123.456})
    for (double const window : {0.0007, 0.01, 0.33, 500.0}) {
      Plan const plan = make_plan(scene_of(strain, 3.7e-4, 0.05, window, 0.5));
      double const step_strain = 3.7e-4 * 0.05;
      EXPECT_GE(static_cast<double>(plan.steps) * step_strain, strain * (1 - 1e-11));
      EXPECT_LT(static_cast<double>(plan.steps - 1) * step_strain, strain);
      EXPECT_GE(static_cast<double>(plan.window_steps) * step_strain, window * (1 - 1e-11));
      EXPECT_LT(static_cast<double>(plan.window_steps - 1) * step_strain, window);
      EXPECT_GE(plan.windows * plan.window_steps, plan.steps);
      EXPECT_LT((plan.windows - 1) * plan.window_steps, plan.steps);
      EXPECT_LE(plan.discarded_windows, plan.windows);
      EXPECT_GE(2 * plan.discarded_windows, plan.windows);
    }
}

TEST(Plan, AWindowMayBeLongerThanTheRunOrShorterThanAStep) {
  Plan const longer = make_plan(scene_of(1.0, 1e-4, 0.05, 7.0, 0.0));
  EXPECT_EQ(longer.windows, 1);
  EXPECT_EQ(longer.window_steps, 1'400'000);
  EXPECT_EQ(make_plan(scene_of(1.0, 1e-4, 0.05, 1e300, 0.0)).windows, 1);
  Plan const shorter = make_plan(scene_of(1.0, 1e-4, 0.05, 1e-9, 0.0));
  EXPECT_EQ(shorter.window_steps, 1);
  EXPECT_EQ(shorter.windows, shorter.steps);
  EXPECT_EQ(make_plan(scene_of(1e-9, 1e-4, 0.05, 1.0, 0.0)).steps, 1);
}

TEST(Plan, TakesTheTimeStepOfTheRule) {
  Scene scene = minimal_scene();
  EXPECT_EQ(make_plan(scene).time_step, 0.2);
  scene.integration.time_step = of_papers;
  EXPECT_EQ(make_plan(scene).time_step, 0.05);
  scene.disks.elasticity = 0.2;
  EXPECT_DOUBLE_EQ(make_plan(scene).time_step, 0.02);
  EXPECT_EQ(make_plan(scene).steps, 10'000'000);
}

TEST(Plan, TooManyStepsOrWindowsAreRefused) {
  auto const refusal_for = [](Scene const& scene) { return refusal_of([&] { make_plan(scene); }); };
  EXPECT_TRUE(has(refusal_for(scene_of(1e9, 1e-10, 0.05, 1e4, 0.5)), "shear.strain = 1"));
  EXPECT_TRUE(
      has(refusal_for(scene_of(1.0, 5e-324, 0.05, 1e4, 0.5)), "shear.strain_rate = 5e-324"));
  EXPECT_TRUE(has(refusal_for(scene_of(1.0, 1e-300, 1e-300, 1e4, 0.5)), "steps"));
  EXPECT_EQ(refusal_for(scene_of(2e5, 1e-9, 0.05, 1e4, 0.5)), "accepted");  // 4e15
  EXPECT_TRUE(has(refusal_for(scene_of(20, 1e-4, 0.05, 1.5e-5, 0.5)),
                  "output.sample_strain = 1.5e-05 makes 1333334 windows"));
  EXPECT_EQ(refusal_for(scene_of(20, 1e-4, 0.05, 2e-5, 0.5)), "accepted");
}

TEST(Plan, TheAdviceForAWindowWorks) {
  for (double const strain : {20.0, 20.4, 1234.5, 7.77}) {
    Scene scene = scene_of(strain, 1e-4, 0.05, 5e-6, 0.5);
    std::string const message = refusal_of([&] { make_plan(scene); });
    auto const advice = message.find("use at least ");
    ASSERT_NE(advice, std::string::npos) << message;
    scene.output.sample_strain = std::stod(message.substr(advice + 13));
    EXPECT_EQ(refusal_of([&] { make_plan(scene); }), "accepted") << message;
  }
}

/// As P1 Eq. (8) and P2 Eq. (11) say: the disks' area is phi L^2.
TEST(Box, HoldsThePackingFraction) {
  Scene scene = minimal_scene();
  for (double const phi : {0.1, 0.6, 0.84335}) {
    scene.disks.packing_fraction = phi;
    double const pi = std::numbers::pi;
    double const area = 512 * pi * 0.25 + 512 * pi * 0.49;
    EXPECT_NEAR(area / (scene.box_length() * scene.box_length()), phi, 1e-14);
    for (double const aspect : {4.0, 0.3}) {
      scene.disks.box_aspect = aspect;
      EXPECT_NEAR(area / (scene.box_length() * scene.box_height()), phi, 1e-14);
      EXPECT_NEAR(scene.box_height() / scene.box_length(), aspect, 1e-14);
    }
    scene.disks.box_aspect = 1;
  }
}

std::string feasibility(Scene const& scene, bool allow_unstable = false) {
  return refusal_of([&] { check_feasible(scene, make_plan(scene), allow_unstable); });
}

TEST(Feasible, ABoxMustHoldTwoContactDistancesAndSkins) {
  Scene scene = minimal_scene();
  scene.disks.count = 12;
  double const width = scene.box_length();
  double const largest = width / 2 - 1.4;
  scene.integration.skin = largest * (1 - 1e-12);
  EXPECT_EQ(feasibility(scene), "accepted");
  scene.integration.skin = largest * (1 + 1e-11);
  std::string const message = feasibility(scene);
  EXPECT_TRUE(has(message, "disks.count = 12 makes a box")) << message;
  EXPECT_TRUE(has(message, "integration.skin")) << message;
}

/// Both lengths: the width of a tall box, the height of a flat one.
TEST(Feasible, ABoxThatIsNotSquareMustHoldThemBothWays) {
  for (bool const tall : {true, false}) {
    Scene scene = minimal_scene();
    scene.disks.count = 100;
    scene.disks.box_aspect = tall ? 4.0 : 0.25;
    double const least = tall ? scene.box_length() : scene.box_height();
    double const largest = least / 2 - 1.4;
    scene.integration.skin = largest * (1 - 1e-12);
    EXPECT_EQ(feasibility(scene), "accepted");
    scene.integration.skin = largest * (1 + 1e-11);
    std::string const message = feasibility(scene);
    EXPECT_TRUE(has(message, "disks.count = 100 with disks.box_aspect = ")) << message;
    EXPECT_TRUE(has(message, "integration.skin") && has(message, "aspect nearer 1")) << message;
    scene.integration.skin = 0.1;
    scene.measure.fields = true;
    EXPECT_TRUE(has(feasibility(scene), "measure.fields")) << feasibility(scene);
  }
}

TEST(Feasible, MoreMemoryThanThereIsIsRefused) {
  Scene scene = minimal_scene();
  EXPECT_EQ(feasibility(scene), "accepted");
  scene.disks.count = 1'000'000'000'000;
  std::string const message = feasibility(scene);
  EXPECT_TRUE(has(message, "disks.count = 1000000000000 needs about") && has(message, "memory"))
      << message;
}

TEST(Feasible, ReplicasTakeMemoryEach) {
  Scene scene = minimal_scene();
  scene.disks.count = 1'000'000;
  Plan const plan = make_plan(scene);
  double const one = memory_needed(scene, plan);
  double const shared = 64e6;  // the program itself
  scene.disks.replicas = 7;
  EXPECT_NEAR(memory_needed(scene, plan), 7 * (one - shared) + shared, 1);
  scene.disks.count = 1'000'000'000;
  scene.disks.replicas = 4096;
  std::string const message = feasibility(scene);
  EXPECT_TRUE(has(message, "disks.count = 1000000000 with disks.replicas = 4096 needs about") &&
              has(message, "or replicas"))
      << message;
}

/// The steps of all replicas are counted together.
TEST(Plan, ReplicasHaveTheStepsOfOneEach) {
  Scene scene = scene_of(20.0, 1e-4, 0.05, 1e-2, 0.5);
  scene.disks.replicas = 4096;
  EXPECT_EQ(make_plan(scene).steps, 4'000'000);
  scene = scene_of(1e9, 1e-4, 0.01, 1e5, 0.5);
  EXPECT_NO_THROW(make_plan(scene));  // 1e15 steps
  scene.disks.replicas = 5;
  EXPECT_TRUE(has(refusal_of([&] { make_plan(scene); }), "steps"));
}

/// Positions and velocities now and at the trial step, lists and a host copy: no run does with less
/// than 150 bytes a disk, and none should be told that it takes 10 kB.
TEST(Feasible, MemoryGrowsWithDisksAndWindows) {
  Scene scene = minimal_scene();
  scene.disks.count = 1'000'000;
  Plan const plan = make_plan(scene);
  double const million = memory_needed(scene, plan);
  scene.disks.count = 2'000'000;
  double const a_disk = (memory_needed(scene, plan) - million) / 1e6;
  EXPECT_GT(a_disk, 150);
  EXPECT_LT(a_disk, 10000);
  scene.disks.model = "CD";
  EXPECT_LT(memory_needed(scene, plan), million + 1e6 * a_disk);  // no spins
  Plan longer = plan;
  longer.windows += 1'000'000;
  EXPECT_GT(memory_needed(scene, longer), memory_needed(scene, plan) + 1e6 * 13 * 8);
}

/// 764 bytes a disk were seen, the program's own left out (CD_n, N = 262144).
TEST(Feasible, MemoryIsThatOfEventsWhereTheyMayBeTaken) {
  Scene scene = minimal_scene();
  scene.disks.elasticity = 2;
  scene.disks.count = 1'000'000;
  Plan const plan = make_plan(scene);
  ASSERT_TRUE(may_take_events(scene));
  EXPECT_GT(memory_needed(scene, plan), 764e6);
  scene.integration.engine = steps_engine;
  EXPECT_LT(memory_needed(scene, plan), 500e6);
  scene.integration.engine = automatic;
  scene.disks.count = 1'000'000'000'000;
  EXPECT_TRUE(has(feasibility(scene), "or integration.engine = \"steps\""));
}

TEST(Plan, WarnsWhereNothingWillBeMeasured) {
  auto const told = [](Scene const& scene) { return plan_warning(scene, make_plan(scene)); };
  auto const nothing = told(scene_of(0.1, 1e-3, 0.05, 0.1, 0.5));
  EXPECT_TRUE(has(nothing, "discards all 1 windows")) << nothing;
  EXPECT_EQ(told(scene_of(0.2, 1e-3, 0.05, 0.1, 0.5)), "");
}

TEST(Plan, WarnsWhereTheOnlyCycleIsTheTransient) {
  Scene scene = parse(oscillation_text);
  auto const told = [&] { return plan_warning(scene, make_plan(scene)); };
  scene.shear.cycles = 1;
  scene.shear.discard = 0.5;
  EXPECT_TRUE(has(told(), "shear.cycles = 1")) << told();
  scene.shear.discard = 0;
  EXPECT_EQ(told(), "");
  scene.shear.discard = 0.5;
  scene.shear.cycles = 2;
  EXPECT_EQ(told(), "");
}

TEST(Feasible, AnUnstableTimeStepNeedsConsent) {
  Scene scene = minimal_scene();
  scene.integration.time_step = 5.0;
  std::string const message = feasibility(scene);
  EXPECT_TRUE(has(message, "integration.time_step = 5 (unstable")) << message;
  EXPECT_TRUE(has(message, "\"auto\" takes 0.2") && has(message, "--allow-unstable"));
  EXPECT_EQ(feasibility(scene, true), "accepted");
}

TEST(Feasible, TheStepsOfTheRulesAreStable) {
  Scene scene = minimal_scene();
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (auto const* mass : {"equal", "area"})
      for (double q = 0.1; q <= 1e6; q *= 1.7) {
        scene.disks.model = model;
        scene.disks.mass = mass;
        scene.disks.elasticity = q;
        scene.shear.strain = 1e-3;
        for (auto const scheme : {papers_scheme, two_stage_scheme}) {
          scene.integration.scheme = scheme;
          EXPECT_EQ(feasibility(scene), "accepted") << model << " " << mass << " Q = " << q;
        }
      }
}

}  // namespace
}  // namespace bagnold
