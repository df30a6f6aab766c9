// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/replicas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

double ratio(std::span<double const> averages) { return averages[0] / averages[1]; }

std::vector<Windows const*> pointers(std::vector<Windows> const& replicas) {
  std::vector<Windows const*> list;
  for (auto const& windows : replicas) list.push_back(&windows);
  return list;
}

/// R systems whose windows fluctuate about a mean of their own, which scatters from system to
/// system.
struct Ensemble {
  std::mt19937_64 random{41};
  std::normal_distribution<double> normal{};

  std::vector<Windows> make(std::size_t replicas, std::size_t windows, double rho, double scatter) {
    std::vector<Windows> made;
    for (std::size_t r = 0; r < replicas; ++r) {
      Autoregressive series(rho, random());
      double const own = scatter * normal(random);
      std::vector<double> values(windows);
      for (double& value : values) value = own + series.next();
      made.push_back(windows_of(values));
    }
    return made;
  }
};

TEST(Replicas, MeanIsTheFunctionOfThePooledAverages) {
  std::vector<Windows> replicas(3, Windows{2, {}, {}});
  replicas[0].push_back(std::vector{100.0, 1.0}, 1.0);  // discarded, as are the other first ones
  replicas[0].push_back(std::vector{1.0, 2.0}, 1.0);
  replicas[1].push_back(std::vector{100.0, 1.0}, 1.0);
  replicas[1].push_back(std::vector{2.0, 10.0}, 2.0);
  replicas[2].push_back(std::vector{100.0, 1.0}, 1.0);
  replicas[2].push_back(std::vector{3.0, 12.0}, 1.0);
  auto const found = estimate(pointers(replicas), 1, ratio);
  EXPECT_DOUBLE_EQ(*found.all.mean, 6.0 / 24.0);
  EXPECT_EQ(found.all.samples, 3u);
  ASSERT_EQ(found.each.size(), 3u);
  EXPECT_DOUBLE_EQ(*found.each[0].mean, 0.5);
  EXPECT_DOUBLE_EQ(*found.each[1].mean, 0.2);
  EXPECT_DOUBLE_EQ(*found.each[2].mean, 0.25);
}

/// (R-1)/R sum_r (f_{-r} - mean)^2 by hand.
TEST(Replicas, ErrorLeavesOutOneReplicaAtATime) {
  double const x[] = {1.0, 2.0, 4.0, 3.0}, y[] = {2.0, 3.0, 5.0, 7.0};
  std::vector<Windows> replicas(4, Windows{2, {}, {}});
  for (int r = 0; r < 4; ++r)
    for (int w = 0; w < 2; ++w)  // two windows that add up to (x, y)
      replicas[r].push_back(std::vector{(w + 1) * x[r] / 3, (w + 1) * y[r] / 3}, 1.0);
  double without[4], mean = 0.0, squares = 0.0;
  for (int r = 0; r < 4; ++r) {
    without[r] = (10.0 - x[r]) / (17.0 - y[r]);
    mean += without[r] / 4;
  }
  for (double const f : without) squares += (f - mean) * (f - mean);
  auto const found = estimate(pointers(replicas), 0, ratio);
  EXPECT_NEAR(*found.all.error, std::sqrt(0.75 * squares), 1e-14);
  EXPECT_EQ(found.all.blocks, 4u);
}

TEST(Replicas, OneIsTheEstimateOfItsWindows) {
  auto const replicas = Ensemble().make(1, 3000, 0.5, 0.0);
  auto const found = estimate(pointers(replicas), 10, identity).all;
  auto const alone = estimate(replicas[0], 10, identity);
  EXPECT_EQ(found.mean, alone.mean);
  EXPECT_EQ(found.error, alone.error);
  EXPECT_EQ(found.correlation, alone.correlation);
  EXPECT_EQ(found.samples, alone.samples);
}

TEST(Replicas, TwoCombineTheirOwnErrors) {
  auto replicas = Ensemble().make(2, 4000, 0.6, 0.0);
  auto const found = estimate(pointers(replicas), 0, identity);
  double const expected = std::hypot(*found.each[0].error, *found.each[1].error) / 2;
  EXPECT_NEAR(*found.all.error, expected, 1e-14);
  EXPECT_NEAR(*found.all.correlation, (*found.each[0].correlation + *found.each[1].correlation) / 2,
              1e-14);

  replicas = Ensemble().make(2, 20, 0.9, 0.0);
  auto const brief = estimate(pointers(replicas), 0, identity).all;
  EXPECT_TRUE(brief.mean);
  EXPECT_FALSE(brief.error);
  EXPECT_NE(brief.remark, "");
}

/// The mean of error^2 over many ensembles is the variance of the mean: within 4 standard errors of
/// that average, each square scattering by (2/(R-1))^(1/2) of itself. The systems are far too short
/// (3 correlation times) for an error of their own, and differ from each other for good.
TEST(Replicas, SquaredErrorsAreRightOnAverage) {
  int const runs = 3000;
  struct Case {
    std::size_t replicas;
    double scatter;
  };
  for (Case const c : {Case{3, 0.0}, {4, 0.0}, {8, 0.0}, {4, 1.0}, {8, 0.5}}) {
    Ensemble ensemble;
    std::size_t const windows = 30;
    Autoregressive const series(0.9, 1);
    double const count = static_cast<double>(c.replicas);
    double const expected =
        (std::pow(series.error_of_mean(windows), 2) + c.scatter * c.scatter) / count;
    double squares = 0.0;
    for (int run = 0; run < runs; ++run) {
      auto const replicas = ensemble.make(c.replicas, windows, 0.9, c.scatter);
      squares += std::pow(*estimate(pointers(replicas), 0, identity).all.error, 2) / runs;
    }
    EXPECT_NEAR(squares / expected, 1.0, 4.0 * std::sqrt(2.0 / (count - 1.0) / runs))
        << c.replicas << " " << c.scatter;
  }
}

TEST(Replicas, UndefinedIsEmptyNeverNaN) {
  std::vector<Windows> replicas(3, Windows{2, {}, {}});
  for (auto& windows : replicas) windows.push_back(std::vector{0.0, 0.0}, 1.0);
  auto found = estimate(pointers(replicas), 0, ratio).all;  // 0/0
  EXPECT_FALSE(found.mean || found.error);
  EXPECT_NE(found.remark, "");

  replicas[1].push_back(std::vector{1.0, 2.0}, 1.0);  // defined through one replica only
  found = estimate(pointers(replicas), 0, ratio).all;
  EXPECT_EQ(found.mean, 0.5);
  EXPECT_FALSE(found.error);
  EXPECT_NE(found.remark, "");

  found = estimate(pointers(replicas), 5, ratio).all;  // nothing measured
  EXPECT_FALSE(found.mean || found.error);
  EXPECT_NE(found.remark, "");
}

}  // namespace
}  // namespace bagnold::statistics
