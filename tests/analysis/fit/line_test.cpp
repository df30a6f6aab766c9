// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/line.hpp"

#include "src/config/errors.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

TEST(Line, InClosedForm) {
  // equal errors e at x = 0, 1, 2, 3: slope error e / sqrt(5), by hand
  Points const points{{0, 1, 2, 3}, {1, 3, 5, 7}, {0.5, 0.5, 0.5, 0.5}};
  auto const found = fit_line(points);
  EXPECT_NEAR(found.value[0], 1.0, 1e-12);
  EXPECT_NEAR(found.value[1], 2.0, 1e-12);
  EXPECT_NEAR(found.error[1], 0.5 / std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(found.error[0], 0.5 * std::sqrt(14.0 / 20.0), 1e-12);
}

/// The error of the meeting point against lines drawn 20000 times.
TEST(Line, IntersectionAgainstMonteCarlo) {
  std::mt19937_64 random(8);
  auto const low = evenly(4, 12, 6), high = evenly(13, 30, 7);
  auto const error = [](double) { return 0.3; };
  auto const falling = [](double x) { return 40.0 - 3.0 * x; };
  auto const level = [](double x) { return 1.0 + 0.05 * x; };
  auto const draw = [&](std::mt19937_64* generator) {
    return intersection(fit_line(sampled(low, falling, error, generator)),
                        fit_line(sampled(high, level, error, generator)));
  };
  auto const exact = draw(nullptr);
  EXPECT_NEAR(exact.x, 39.0 / 3.05, 1e-9);
  double sum = 0.0, squares = 0.0;
  int const sets = 20000;
  for (int set = 0; set < sets; ++set) {
    double const off = draw(&random).x - exact.x;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / sets, 0.0, 0.05 * exact.error);
  EXPECT_NEAR(std::sqrt(squares / sets) / exact.error, 1.0, 0.03);
}

/// A difference that leaves zero at 20: the split is found, and pulls of the place are right.
TEST(Line, TwoLinesMeetWhereTheDifferenceLeavesZero) {
  std::mt19937_64 random(9);
  Pulls pulls;
  for (int set = 0; set < 1000; ++set) {
    // a point on the corner itself would fit either line
    auto const points = sampled(
        evenly(4.5, 39.5, 18), [](double q) { return std::max(0.0, 100.0 * (20.0 - q)); },
        [](double) { return 10.0; }, &random);
    auto const found = fit_two_lines(points);
    pulls.add(found.meeting.x, 20.0, found.meeting.error);
  }
  pulls.expect_right(0.1);
}

TEST(Line, TheSplitCanBeGiven) {
  auto const points = sampled(
      evenly(0, 10, 11), [](double x) { return x < 4.5 ? 0.0 : x - 4.5; },
      [](double) { return 0.1; }, nullptr);
  double const at = 6.5;
  EXPECT_EQ(fit_two_lines(points, &at).split, 7u);
  EXPECT_EQ(fit_two_lines(points).split, 5u);
  double const nowhere = 20.0;
  EXPECT_THROW(fit_two_lines(points, &nowhere), InputError);
}

/// Z/gammadot at two rates part at once: lines through either side meet far outside.
TEST(Line, AStepIsTheMiddleOfItsGap) {
  auto const step = [](double q) { return q < 18.0 ? 3e6 - 1e3 * q : 2.0; };
  auto const error = [](double y) { return 0.1 * std::abs(y); };
  auto const points = sampled(evenly(5, 40, 15), step, error, nullptr);  // 17.5, 20
  auto const found = fit_two_lines(points);
  EXPECT_TRUE(found.step);
  EXPECT_NEAR(found.meeting.x, 18.75, 1e-9);
  EXPECT_NEAR(found.meeting.error, 2.5 / std::sqrt(12.0), 1e-9);
  // two points are enough on either side
  auto const end = fit_two_lines(sampled(evenly(4, 20, 9), step, error, nullptr));  // 16, 18
  EXPECT_TRUE(end.step);
  EXPECT_NEAR(end.meeting.x, 17.0, 1e-9);
}

TEST(Line, WhatNeitherMeetsNorStepsIsNoTransition) {
  std::mt19937_64 random(41);
  int refused = 0, sets = 200;
  for (int set = 0; set < sets; ++set) {
    auto const points = sampled(
        evenly(0, 10, 12), [](double) { return 1.0; }, [](double) { return 0.1; }, &random);
    try {
      auto const found = fit_two_lines(points);
      EXPECT_GE(found.meeting.x, 0.0);
      EXPECT_LE(found.meeting.x, 10.0);
    } catch (InputError const&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Line, BadInput) {
  EXPECT_THROW(fit_line({{1}, {1}, {}}), InputError);
  EXPECT_THROW(fit_line({{1, 1}, {1, 2}, {}}), InputError);
  EXPECT_THROW(fit_two_lines({{1, 2, 3}, {1, 2, 3}, {}}), InputError);
}

}  // namespace
}  // namespace bagnold::analysis
