// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/crossing.hpp"

#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

/// p = 3000 gammadot^2 is straight in logarithms: the place of p = 2e-5 comes out exactly.
TEST(Crossing, OfAPowerLawIsExact) {
  auto const p = sampled(
      geometric(1e-6, 1e-3, 7), [](double rate) { return 3000.0 * rate * rate; },
      [](double y) { return 0.02 * y; }, nullptr);
  auto const found = where_level(with_logarithms(p, true, true), std::log(2e-5));
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::exp(found->value), std::sqrt(2e-5 / 3000.0), 1e-15);
}

TEST(Crossing, ErrorsAgainstMonteCarlo) {
  std::mt19937_64 random(14);
  auto const rise = [](double x) { return 3.0 * x; };
  auto const error = [](double) { return 0.05; };
  auto const place = evenly(0, 5, 6);
  Pulls crossing, height;
  for (int set = 0; set < 4000; ++set) {
    auto const points = sampled(place, rise, error, &random);
    auto const found = where_level(points, 7.2);
    ASSERT_TRUE(found);
    crossing.add(found->value, 2.4, found->error);
    auto const at = at_place(points, 2.4, 0.0);
    ASSERT_TRUE(at);
    height.add(at->value, 7.2, at->error);
  }
  crossing.expect_right(0.02);
  height.expect_right(0.02);
}

TEST(Crossing, OutsideIsNone) {
  Points const points{{1, 2, 3}, {1, 2, 3}, {}};
  EXPECT_FALSE(where_level(points, 3.5));
  EXPECT_FALSE(at_place(points, 0.5, 0.0));
  ASSERT_TRUE(where_level(points, 2.0));
  EXPECT_DOUBLE_EQ(where_level(points, 2.0)->value, 2.0);
  EXPECT_DOUBLE_EQ(where_level(points, 1.0)->value, 1.0);
}

}  // namespace
}  // namespace bagnold::analysis
