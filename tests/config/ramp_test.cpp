// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/ramp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/config/plan.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

/// With the papers' time step.
Scene ramp_scene(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "integration.time_step=paper");
  return parse(ramp_text, overrides);
}

std::string plan_refusal(std::vector<std::string> const& overrides) {
  try {
    make_plan(ramp_scene(overrides));
  } catch (InputError const& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Ramp, HasTheLengthsOfItsScene) {
  Ramp const ramp = make_ramp(ramp_scene());
  EXPECT_EQ(ramp.piece_steps, 20);       // 1 tau_e of 0.05
  EXPECT_EQ(ramp.window_steps, 20'000);  // 1e3 tau_e
  EXPECT_EQ(ramp.fast_steps, 40'000);    // strain 2 at 1e-3
  EXPECT_EQ(ramp.slow_steps, 400'000);   // strain 2 at 1e-4
  EXPECT_EQ(ramp.leg_pieces, 20'000);    // two decades at 1e-4 decades a tau_e
  EXPECT_EQ(ramp.steps(), 440'000 + 2 * 400'000);
  Plan const plan = make_plan(ramp_scene());
  EXPECT_EQ(plan.windows, 22 + 40);
  EXPECT_EQ(plan.discarded_windows, 22);
}

/// P2 Eqs. (38), (39): from one tau_e to the next the rate grows by 10^(kappa~).
TEST(Ramp, FollowsEq38) {
  Ramp const ramp = make_ramp(ramp_scene());
  for (std::int64_t k = 0; k < ramp.leg_pieces; k += 37) {
    auto const up = ramp.piece(ramp.first_leg() + 20 * k);
    EXPECT_NEAR(up.rate, 1e-4 * std::pow(10, 1e-4 * static_cast<double>(k)), 1e-14);
    EXPECT_EQ(up.direction, 1);
    EXPECT_EQ(up.begin, ramp.first_leg() + 20 * k);
    EXPECT_EQ(up.end - up.begin, 20);
    auto const down = ramp.piece(ramp.steps() - 1 - 20 * k);  // mirrored
    EXPECT_EQ(down.rate, up.rate);
    EXPECT_EQ(down.direction, -1);
  }
  EXPECT_EQ(ramp.piece(0).rate, 1e-3);
  EXPECT_EQ(ramp.piece(39'999).rate, 1e-3);
  EXPECT_EQ(ramp.piece(40'000).rate, 1e-4);
  EXPECT_EQ(ramp.piece(439'999).direction, 0);
}

/// The closed form against the sum over steps.
TEST(Ramp, StrainIsTheSumOverSteps) {
  Ramp const ramp = make_ramp(ramp_scene(
      {"shear.ramp_rate=2e-3", "shear.ramp_window=50", "shear.cycles=2", "shear.strain=0.1"}));
  long double sum = 0;
  for (std::int64_t step = 0; step < ramp.steps(); ++step) {
    ASSERT_NEAR(static_cast<double>(ramp.strain(step)), static_cast<double>(sum), 1e-13) << step;
    sum += static_cast<long double>(ramp.piece(step).rate) * ramp.time_step;
  }
  EXPECT_NEAR(static_cast<double>(ramp.strain(ramp.steps())), static_cast<double>(sum), 1e-13);
}

TEST(Ramp, ManyPiecesAreSummedExactly) {
  // 2e6 pieces a leg: gammadot_low T (10^2 - 1) / (10^kappa~ - 1)
  Ramp const ramp = make_ramp(ramp_scene({"shear.ramp_rate=1e-6"}));
  double const leg = static_cast<double>(ramp.strain(ramp.first_leg() + ramp.leg_steps()) -
                                         ramp.strain(ramp.first_leg()));
  EXPECT_NEAR(leg / (1e-4 * 99 / std::expm1(1e-6 * std::log(10.0))), 1, 1e-12);
}

TEST(Ramp, UpAndDownStrainAlike) {
  Ramp const ramp = make_ramp(ramp_scene({"shear.cycles=3"}));
  auto const at = [&](std::int64_t leg) {
    return ramp.strain(ramp.first_leg() + leg * ramp.leg_steps());
  };
  for (int leg = 1; leg < 6; ++leg)
    EXPECT_NEAR(static_cast<double>((at(leg + 1) - at(leg)) / (at(1) - at(0))), 1, 1e-15);
  Plan const plan = make_plan(ramp_scene({"shear.cycles=3"}));
  auto const first = plan.discarded_windows, leg = ramp.leg_steps() / plan.window_steps;
  for (std::int64_t w = 0; w < leg; ++w)
    EXPECT_NEAR(plan.mean_rate(first + w) / plan.mean_rate(first + 2 * leg - 1 - w), 1, 1e-12);
  EXPECT_EQ(plan.direction(first - 1), 0);
  EXPECT_EQ(plan.direction(first), 1);
  EXPECT_EQ(plan.direction(first + leg - 1), 1);
  EXPECT_EQ(plan.direction(first + leg), -1);
}

TEST(Ramp, LegsAreWholeWindows) {
  Ramp const ramp = make_ramp(ramp_scene({"shear.strain_rate_high=1.01e-2"}));
  EXPECT_EQ(ramp.leg_steps() % ramp.window_steps, 0);
  double const top = ramp.piece(ramp.first_leg() + ramp.leg_steps() - 1).rate;
  EXPECT_GE(top, 1.0099e-2);
  EXPECT_LT(top, 1.01e-2 * std::pow(10, 1e-4 * 1000));
}

TEST(Ramp, IsReachedByWayOf1e_3OnlyFromBelowAndFromRandom) {
  EXPECT_EQ(make_ramp(ramp_scene({"shear.strain_rate=1e-3"})).fast_steps, 0);
  EXPECT_EQ(make_ramp(ramp_scene({"start.kind=state", "start.file=a.h5"})).fast_steps, 0);
  EXPECT_EQ(make_ramp(ramp_scene({"start.kind=state", "start.file=a.h5"})).slow_steps, 400'000);
}

TEST(Ramp, TheTimeStepDividesThePiece) {
  EXPECT_EQ(make_plan(ramp_scene()).time_step, 0.05);
  EXPECT_NEAR(make_plan(ramp_scene({"disks.elasticity=0.3"})).time_step, 1.0 / 34, 1e-16);  // 0.03
  EXPECT_EQ(make_plan(parse(ramp_text)).time_step, 0.2);  // that of two stages
  EXPECT_EQ(make_plan(parse(ramp_text, {"disks.elasticity=0.7"})).time_step, 0.125);  // 0.14
  EXPECT_NE(plan_refusal({"integration.time_step=0.03"}).find("use 0.0294"), std::string::npos)
      << plan_refusal({"integration.time_step=0.03"});
  EXPECT_EQ(plan_refusal({"integration.time_step=0.03", "shear.ramp_every=3"}).find("integration"),
            std::string::npos);
  EXPECT_NE(
      plan_refusal({"shear.ramp_every=3"}).find("shear.ramp_window = 1000 (must be a whole number"),
      std::string::npos);
  EXPECT_EQ(plan_refusal({"shear.ramp_every=10"}), "accepted");
}

TEST(Ramp, TooLongIsRefused) {
  EXPECT_TRUE(has(plan_refusal({"shear.ramp_rate=1e-14"}), "shear.ramp_rate = 1e-14 takes"));
  EXPECT_TRUE(has(plan_refusal({"shear.ramp_window=1", "shear.ramp_rate=1e-7"}),
                  "shear.ramp_window = 1 makes"));
}

}  // namespace
}  // namespace bagnold
