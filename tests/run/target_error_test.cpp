// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/target_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernels/physics/sums/sums.hpp"
#include "src/run/collisions.hpp"
#include "src/run/warnings/checks.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

/// A run whose windows have contacts Z and a pressure with noise of a relative size, or none.
class Target : public testing::Test {
 protected:
  Target() {
    scene.shear.strain = 20.0;
    scene.shear.target_error = {{"B_p", 0.05}};
  }

  void judge(double contacts, double pressure, double noise) {
    run = {};
    run.scene = scene;
    run.plan = make_plan(scene);
    run.box_length = scene.box_length();
    std::normal_distribution<double> normal(1, noise);
    auto& windows = run.replicas.emplace_back().measurement.windows;
    windows.columns = SumColumns::count_rotating;
    for (std::int64_t w = 0; w < run.plan.windows; ++w) {
      std::vector<double> row(SumColumns::count_rotating);
      double const sum = noise > 0 ? pressure * normal(random) : pressure;
      row[SumColumns::elastic_xx] = row[SumColumns::elastic_yy] = sum;
      row[SumColumns::contacts] = contacts * static_cast<double>(scene.disks.count);
      windows.push_back(row, 1.0);
    }
    judge_errors(run);
  }

  std::mt19937_64 random{3};
  Scene scene = minimal_scene();
  bagnold::Run run;
};

TEST_F(Target, IsMetByASteadySeries) {
  judge(1.0, 1.0, 0.1);
  EXPECT_TRUE(run.target_met);
  ASSERT_TRUE(run.reached.at("B_p"));
  EXPECT_NEAR(*run.reached.at("B_p"), 0.1 / std::sqrt(1000), 0.002);
}

/// Free disks at rest: their pressure is rounding, which does not change.
TEST_F(Target, IsNotMetByWhatDoesNotVary) {
  for (double const pressure : {0.0, 9e-33, 1.0}) {
    judge(1.0, pressure, 0.0);
    EXPECT_FALSE(run.target_met) << pressure;
    EXPECT_FALSE(run.reached.at("B_p")) << pressure;
    EXPECT_EQ(until_target(run), "") << pressure;
  }
}

/// Not in a run that few_collisions warns of, nor in the look before its end.
TEST_F(Target, IsNotMetBeforeDisksHaveMet) {
  double const half = 10;  // the measured strain
  double const enough = fewest_collisions / collisions_per_disk(scene, 1.0, half);
  for (double const contacts : {0.0, 0.9 * enough, 1.1 * enough, 2.0 * enough}) {
    judge(contacts, 1.0, 0.1);
    std::vector<NamedEstimate> const list = estimates(run);
    EXPECT_EQ(few_collisions({run, list}).has_value(), contacts < enough);
    EXPECT_EQ(run.target_met, contacts > 1.5 * enough)
        << contacts;  // looks are a factor of 1.5 apart
  }
}

/// Errors go with the root of the strain: (reached/wanted)^2 times as much, and as much again as
/// lies between two looks.
TEST_F(Target, AMissedOneTellsTheStrainThatItTakes) {
  scene.shear.target_error = {{"B_p", 1e-3}, {"p", 0.5}};
  judge(1.0, 1.0, 0.1);
  EXPECT_FALSE(run.target_met);
  double const times = std::pow(*run.reached.at("B_p") / 1e-3, 2);
  EXPECT_NEAR(times, 10, 2);
  EXPECT_EQ(until_target(run), longer_run(run, 1.5 * times));
}

/// The error alone would be met at once, but disks have hardly collided.
TEST_F(Target, FewCollisionsTakeMoreStrainThanTheError) {
  double const half = 10, share = 0.1;
  double const enough = fewest_collisions / collisions_per_disk(scene, 1.0, half);
  scene.shear.target_error = {{"B_p", 0.5}};
  judge(share * enough, 1.0, 0.1);
  EXPECT_FALSE(run.target_met);
  double const measured = 20.0 * (1 - static_cast<double>(run.plan.discarded_windows) /
                                          static_cast<double>(run.plan.windows));
  EXPECT_EQ(until_target(run), longer_run(run, 1.5 * half / measured / share));
}

}  // namespace
}  // namespace bagnold
