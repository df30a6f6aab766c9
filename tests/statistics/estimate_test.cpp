// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/estimate.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "src/statistics/blocking.hpp"
#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double ratio(std::span<double const> averages) { return averages[0] / averages[1]; }

TEST(Estimate, MeanIsTheFunctionOfTheAverages) {
  Windows windows{2, {}, {}};
  windows.push_back(std::vector{100.0, 100.0}, 1.0);  // discarded
  windows.push_back(std::vector{1.0, 2.0}, 1.0);
  windows.push_back(std::vector{1.0, 10.0}, 1.0);
  Estimate const found = estimate(windows, 1, ratio);
  EXPECT_DOUBLE_EQ(*found.mean, 1.0 / 6.0);  // the mean of ratios would be 0.3
  EXPECT_EQ(found.samples, 2u);
}

TEST(Estimate, ShortSeriesHasNoErrorAndSaysSo) {
  Autoregressive series(0.95, 3);  // tau = 19.5
  std::vector<double> values;
  for (std::size_t n : {0u, 1u, 2u, 7u, 8u, 30u, 200u}) {
    while (values.size() < n) values.push_back(series.next());
    Estimate const found = estimate(windows_of(values), 0, identity);
    EXPECT_EQ(found.mean.has_value(), n > 0);
    EXPECT_FALSE(found.error) << n;
    EXPECT_FALSE(found.correlation);
    EXPECT_EQ(found.blocks, 0u);
    EXPECT_NE(found.remark.find("run"), std::string::npos) << found.remark;
  }
  while (values.size() < 20000) values.push_back(series.next());
  Estimate const found = estimate(windows_of(values), 0, identity);
  EXPECT_TRUE(found.error);
  EXPECT_FALSE(found.rough);
  EXPECT_EQ(found.remark, "");
}

/// White noise of 16 values: blocks of (8 n / 4)^(1/3), 3.2, so of 4, and 4 of them.
TEST(Estimate, OfFourBlocksIsRough) {
  Autoregressive series(0.0, 8);
  Estimate found;
  std::vector<double> values;
  do {  // a draw that blocking takes for white
    values.clear();
    for (int i = 0; i < 16; ++i) values.push_back(series.next());
    found = estimate(windows_of(values), 0, identity);
  } while (!found.error || found.blocks != 4);
  double const se_1 = block_levels(values).front().standard_error;
  double const tau = *found.correlation;
  EXPECT_TRUE(found.rough);
  EXPECT_NEAR(*found.error, 1.6534 * se_1 * std::sqrt(2.0 * tau), 1e-3 * *found.error);
  EXPECT_NE(found.remark.find("rough, from 4 blocks: run about"), std::string::npos);
}

TEST(Estimate, RemarkSaysHowMuchLonger) {
  Autoregressive series(0.0, 4);
  std::vector<double> values;
  for (int i = 0; i < 4; ++i) values.push_back(series.next());
  EXPECT_EQ(estimate(windows_of(values), 0, identity).remark,
            "worth about 4 independent windows: run about 12 times longer for an error");
}

TEST(Estimate, ConstantSeriesHasErrorZero) {
  for (double value : {0.0, 0.1, -1e300, 3e-310}) {
    Estimate const found = estimate(windows_of(std::vector<double>(1000, value)), 0, identity);
    EXPECT_NEAR(*found.mean, value, 1e-12 * std::abs(value));
    EXPECT_EQ(found.error, 0.0);
    EXPECT_FALSE(found.correlation);
  }
  // Of two quantities that fluctuate together the ratio is constant.
  Autoregressive series(0.5, 5);
  Windows windows{2, {}, {}};
  for (int i = 0; i < 1000; ++i) {
    double const x = 5.0 + series.next();
    windows.push_back(std::vector{x, 3.0 * x}, 1.0);
  }
  Estimate const found = estimate(windows, 0, ratio);
  EXPECT_NEAR(*found.mean, 1.0 / 3.0, 1e-14);
  EXPECT_EQ(found.error, 0.0);
}

TEST(Estimate, UndefinedIsEmptyNeverNaN) {
  Windows windows{2, {}, {}};
  for (int i = 0; i < 100; ++i) windows.push_back(std::vector{0.0, 0.0}, 1.0);
  Estimate const zero = estimate(windows, 0, ratio);  // 0/0
  EXPECT_FALSE(zero.mean || zero.error || zero.correlation);
  EXPECT_NE(zero.remark, "");

  windows.push_back(std::vector{1.0, 2.0}, 1.0);  // defined through one window only
  Estimate const one = estimate(windows, 0, ratio);
  EXPECT_EQ(one.mean, 0.5);
  EXPECT_FALSE(one.error);
  EXPECT_NE(one.remark, "");

  windows.push_back(std::vector{nan, 2.0}, 1.0);
  EXPECT_FALSE(estimate(windows, 0, ratio).mean);
}

/// A window of weight 3 stands for three evaluations, however they are cut into windows.
TEST(Estimate, LastWindowMayWeighLess) {
  Autoregressive series(0.0, 6);
  Windows windows{1, {}, {}};
  double total = 0.0, weights = 0.0;
  for (int i = 0; i < 1001; ++i) {
    double const weight = i == 1000 ? 1.0 : 4.0;
    double sum = 0.0;  // of `weight` values, variance 1 each, mean 2
    for (int k = 0; k < weight; ++k) sum += 2.0 + series.next();
    windows.push_back({&sum, 1}, weight);
    total += sum;
    weights += weight;
  }
  Estimate const found = estimate(windows, 0, identity);
  EXPECT_NEAR(*found.mean, total / weights, 1e-14);
  EXPECT_NEAR(*found.error, 1.0 / std::sqrt(weights), 0.2 / std::sqrt(weights));
}

/// Blocks of one size, f linear: the error is that of the block means, freed from the end effect.
TEST(Jackknife, IsTheErrorOfBlockMeans) {
  Autoregressive series(0.7, 7);
  std::vector<double> values;
  for (int i = 0; i < 512; ++i) values.push_back(series.next());
  Windows const windows = windows_of(values);
  Function const f = identity;
  Jackknife jackknife(windows, 0, f);
  for (BlockLevel const& level : block_levels(values)) {
    EXPECT_NEAR(jackknife.error(level.length), level.standard_error, 1e-12);
  }
  auto const deviations = jackknife.deviations();
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(deviations[i], values[i] - jackknife.value(), 1e-10);
  }
}

}  // namespace
}  // namespace bagnold::statistics
