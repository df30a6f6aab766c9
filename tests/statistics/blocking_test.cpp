// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/blocking.hpp"

#include <gtest/gtest.h>

#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

TEST(Blocking, LevelsByHand) {
  std::vector<double> const series{1, 3, 2, 6, 5, 7, 100};
  auto const levels = block_levels(std::vector<double>(series.begin(), series.begin() + 6));
  ASSERT_EQ(levels.size(), 2u);  // 6 values, 3 blocks, then 1
  EXPECT_EQ(levels[1].length, 2u);
  EXPECT_EQ(levels[1].blocks, 3u);
  // Mean 4: squares 9 + 1 + 4 + 4 + 1 + 9 = 28; blocks 2, 4, 6.
  EXPECT_NEAR(levels[0].standard_error, std::sqrt(28.0 / 30.0), 1e-15);
  EXPECT_NEAR(levels[1].standard_error, std::sqrt(8.0 / 6.0), 1e-15);
  EXPECT_NEAR(block_levels(series)[1].standard_error, std::sqrt(8.0 / 6.0), 1e-15);  // odd one off
  EXPECT_TRUE(block_levels(std::vector<double>{1.0}).empty());
}

TEST(Blocking, FirstLevelThatMeetsTheCriterion) {
  // n = 500, se ratio 1, 1.5, 2, 2, 2: B^3 > 1000 ratio^4 = 16000 from B = 32 on.
  std::vector<BlockLevel> levels;
  for (std::size_t k = 0; k < 7; ++k) {
    levels.push_back({std::size_t{1} << k, std::size_t{500} >> k, k == 0 ? 1 : k == 1 ? 1.5 : 2.0});
  }
  EXPECT_EQ(automatic_level(levels, 500)->length, 32u);
  levels.resize(4);
  EXPECT_FALSE(automatic_level(levels, 500));
  EXPECT_EQ(block_length(2.0, 500), 26u);  // 16000^(1/3) = 25.2
}

TEST(Blocking, EndEffectOfExponentialCorrelation) {
  // A block mean has exactly variance error_of_mean(B)^2, hence 2 tau_B = B var.
  for (double rho : {0.3, 0.9, 0.99}) {
    Autoregressive const series(rho, 1);
    double const tau = series.correlation_time();
    std::size_t const B = static_cast<std::size_t>(12.0 * tau);
    double const tau_of_blocks =
        0.5 * static_cast<double>(B) * std::pow(series.error_of_mean(B), 2);
    EXPECT_LT(tau_of_blocks, 0.95 * tau);
    EXPECT_NEAR(without_end_effect(tau_of_blocks, B), tau, 1e-4 * tau);
  }
  EXPECT_EQ(without_end_effect(0.5, 10), 0.5);
  EXPECT_EQ(without_end_effect(0.2, 10), 0.2);
  EXPECT_EQ(without_end_effect(9.0, 10), 5.0);  // no solution: the most that blocks of 10 can tell
}

}  // namespace
}  // namespace bagnold::statistics
