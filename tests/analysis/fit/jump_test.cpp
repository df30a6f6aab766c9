// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/jump.hpp"

#include "src/config/errors.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

/// R_v of a banded region between 0.7953 and 0.8072.
double banded(double phi) { return phi > 0.7953 && phi < 0.8072 ? 22.0 : 1.2; }

TEST(Jump, LiesBetweenTheTwoPointsThatDiffer) {
  auto const points = sampled(
      evenly(0.77, 0.82, 51), banded, [](double y) { return 0.05 * y; }, nullptr);
  auto const up = find_jump(points, Direction::up, 2.0);
  auto const down = find_jump(points, Direction::down, 2.0);
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(up->x, 0.7955, 1e-9);
  EXPECT_NEAR(down->x, 0.8075, 1e-9);
  EXPECT_NEAR(up->error, 0.001 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(up->after / up->before, 22.0 / 1.2, 1e-9);
}

/// A jump is anywhere between two points: over many places the error is the spread.
TEST(Jump, ErrorIsTheSpreadOfPlaces) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> place(0.79, 0.80);
  Pulls pulls;
  for (int set = 0; set < 2000; ++set) {
    double const truth = place(random);
    auto const points = sampled(
        evenly(0.77, 0.82, 26), [&](double phi) { return phi > truth ? 20.0 : 1.1; },
        [](double y) { return 0.03 * y; }, &random);
    auto const found = find_jump(points, Direction::up, 2.0);
    ASSERT_TRUE(found);
    pulls.add(found->x, truth, found->error);
  }
  EXPECT_NEAR(pulls.mean(), 0.0, 0.1);
  EXPECT_NEAR(pulls.variance(), 1.0, 0.1);
}

/// P_el ~ 1/Q, a drop by 100 over three points, then P_el ~ Q: the middle of the drop alone.
TEST(Jump, MiddleOfABroadDrop) {
  Points const points{{1, 2, 4, 8, 9, 10, 11, 20, 40},
                      {1.0, 0.5, 0.25, 0.125, 0.125e-1, 0.125e-2, 0.12e-2, 0.2e-2, 0.4e-2},
                      {}};
  auto const found = find_jump(points, Direction::down, 2.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 9.0, 1e-9);
  EXPECT_DOUBLE_EQ(found->before, 0.125);
  EXPECT_DOUBLE_EQ(found->after, 0.125e-2);
}

/// R_v at 3e-5 over steps of 0.004 and 0.002: a narrow step in the rise does not cut it short.
TEST(Jump, WidensOverStepsOfSeveralWidths) {
  Points const points{{0.784, 0.788, 0.792, 0.796, 0.798, 0.800, 0.802, 0.804},
                      {1.4, 1.4, 4.9, 20.0, 92.0, 64.0, 6.6, 5.0},
                      {}};
  auto const found = find_jump(points, Direction::up, 2.0);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->before, 1.4);
  EXPECT_DOUBLE_EQ(found->after, 92.0);
  EXPECT_NEAR(found->x, 0.7944, 1e-4);
}

TEST(Jump, NoneWhereThereIsNone) {
  std::mt19937_64 random(13);
  auto const noise = [](double y) { return 0.1 * y; };
  auto const smooth = [](double phi) { return 1.0 + 3.0 * (phi - 0.77); };
  auto const points = sampled(evenly(0.77, 0.82, 26), smooth, noise, &random);
  EXPECT_FALSE(find_jump(points, Direction::up, 2.0));
  EXPECT_FALSE(find_jump({{1, 2, 3}, {1, 2, 3}, {}}, Direction::down, 1.0));
  // a factor of 3, but within the errors
  EXPECT_FALSE(find_jump({{1, 2}, {1, 3}, {0.5, 2}}, Direction::up, 2.0));
  // p ~ 1/Q over three decades, in ln Q
  auto const power = sampled(
      evenly(0, 7, 15), [](double x) { return std::exp(-x); }, [](double y) { return 0.03 * y; },
      &random);
  EXPECT_FALSE(find_jump(power, Direction::down, 2.0));
  EXPECT_FALSE(find_jump({{1, 2, 3}, {9, 3, 1}, {}}, Direction::down, 2.0));
  EXPECT_THROW(find_jump({{1, 2}, {1, -3}, {}}, Direction::up, 2.0), InputError);
}

TEST(Jump, SaysWhyThereIsNone) {
  auto const why = [](Points const& points) { return why_no_jump(points, Direction::down, 2.0); };
  EXPECT_EQ(why({{1, 2, 3, 4}, {9, 9, 1, 1}, {}}), "");
  EXPECT_EQ(why({{1, 2, 3}, {1, 2, 3}, {}}), "no interval goes that way");
  EXPECT_NE(why({{1, 2, 3}, {9, 3, 1}, {}}).find("all intervals lie within it"), std::string::npos);
  // with a point outside the same three are a jump
  EXPECT_EQ(why({{0, 1, 2, 3}, {9, 9, 3, 1}, {}}), "");
  EXPECT_NE(why({{1, 2, 3, 4}, {9, 9, 8, 8}, {}}).find("--least-factor"), std::string::npos);
  EXPECT_NE(why({{1, 2}, {3, 1}, {2, 1}}).find("three of its errors"), std::string::npos);
  EXPECT_NE(why({{1, 2, 3, 4, 5, 6}, {32, 16, 12, 3, 2.5, 1.3}, {}}).find("three times as steep"),
            std::string::npos);
}

}  // namespace
}  // namespace bagnold::analysis
