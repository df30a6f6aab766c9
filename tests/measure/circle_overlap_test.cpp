// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/circle_overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bagnold {
namespace {

/// Common area of circles at 0 and (d, 0) by the midpoint rule over chords along y.
double integrated(double R, double r, double d) {
  constexpr int points = 200000;
  double const width = 2 * r / points;
  double area = 0;
  for (int k = 0; k < points; ++k) {
    double const from_r = -r + (k + 0.5) * width, from_R = from_r + d;
    if (std::abs(from_R) >= R) continue;
    area += 2 * width *
            std::min(std::sqrt(r * r - from_r * from_r), std::sqrt(R * R - from_R * from_R));
  }
  return area;
}

TEST(CircleOverlap, IsTheIntegral) {
  for (double const r : {0.5, 0.7, 4.0})
    for (double const d : {3.35, 3.5, 3.8, 4.0, 4.3, 4.499})
      EXPECT_NEAR(circle_overlap(4.0, r, d), integrated(4.0, r, d), 2e-6) << r << " at " << d;
}

TEST(CircleOverlap, WholeOrNone) {
  EXPECT_DOUBLE_EQ(circle_overlap(4.0, 0.5, 0.0), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(circle_overlap(4.0, 0.5, 3.5), std::numbers::pi / 4);
  EXPECT_EQ(circle_overlap(4.0, 0.5, 4.5), 0.0);
  EXPECT_NEAR(circle_overlap(4.0, 0.5, 4.5 - 1e-9), 0.0, 1e-12);
}

TEST(CircleBelow, CutsTheCircle) {
  double const whole = std::numbers::pi * 0.49;
  EXPECT_EQ(circle_below(0.7, -0.8), 0.0);
  EXPECT_DOUBLE_EQ(circle_below(0.7, 0.9), whole);
  EXPECT_DOUBLE_EQ(circle_below(0.7, 0.0), whole / 2);
  EXPECT_NEAR(circle_below(0.7, 0.3) + circle_below(0.7, -0.3), whole, 1e-15);
  // a half plane is a huge circle
  EXPECT_NEAR(circle_below(0.7, 0.3), integrated(1e6, 0.7, 1e6 - 0.3), 1e-5);
}

}  // namespace
}  // namespace bagnold
