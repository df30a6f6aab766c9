// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/steady_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/statistics/estimate.hpp"
#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

/// The definition, sum by sum: batches of 5, all truncations up to the middle, the earliest of equals.
std::size_t plain_mser(std::vector<double> const& series) {
  std::vector<double> z;
  for (std::size_t j = 0; j + 5 <= series.size(); j += 5)
    z.push_back((series[j] + series[j + 1] + series[j + 2] + series[j + 3] + series[j + 4]) / 5);
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t d = 0; d <= z.size() / 2; ++d) {
    double const left = static_cast<double>(z.size() - d);
    double mean = 0.0, squares = 0.0;
    for (std::size_t j = d; j < z.size(); ++j) mean += z[j] / left;
    for (std::size_t j = d; j < z.size(); ++j) squares += (z[j] - mean) * (z[j] - mean);
    if (squares / (left * left) < least) {
      least = squares / (left * left);
      best = d;
    }
  }
  return 5 * best;
}

std::vector<double> noise(Autoregressive& source, std::size_t n, double size = 1.0) {
  source.value = source.normal(source.random);
  std::vector<double> series(n);
  for (double& x : series) x = size * source.next();
  return series;
}

TEST(SteadyStart, IsTheMinimumOfTheDefinition) {
  Autoregressive source(0.7, 3);
  for (int run = 0; run < 200; ++run) {
    auto series = noise(source, static_cast<std::size_t>(20 + 7 * run));
    for (std::size_t t = 0; t < series.size(); ++t)
      series[t] += 5 * std::exp(-static_cast<double>(t) / (1 + run));
    auto const start = steady_start(series);
    std::size_t const expected = plain_mser(series);
    bool const at_limit = expected == series.size() / 5 / 2 * 5;
    EXPECT_EQ(start.found, !at_limit);
    EXPECT_EQ(start.first, at_limit ? (series.size() + 1) / 2 : expected);
  }
}

TEST(SteadyStart, OfAStepIsTheStep) {
  std::vector<double> series(1000, 1.0);
  for (std::size_t t = 0; t < 1000; ++t) series[t] += (t < 300 ? 4.0 : 0.0) + (t % 2 ? 0.1 : -0.1);
  auto const start = steady_start(series);
  EXPECT_TRUE(start.found);
  EXPECT_EQ(start.first, 300u);
}

TEST(SteadyStart, OfATransientThatGoesOnIsNotFound) {
  std::vector<double> series(1001);
  for (std::size_t t = 0; t < series.size(); ++t) series[t] = static_cast<double>(t);
  EXPECT_FALSE(steady_start(series).found);
  EXPECT_EQ(steady_start(series).first, 501u);
}

TEST(SteadyStart, OfTooLittleIsNotFound) {
  for (std::size_t n = 0; n < 10; ++n) {
    std::vector<double> const series(n, 1.0);
    EXPECT_FALSE(steady_start(series).found);
    EXPECT_EQ(steady_start(series).first, (n + 1) / 2);
  }
}

TEST(SteadyStart, OfAConstantLosesNothing) {
  auto const start = steady_start(std::vector<double>(100, 3.0));
  EXPECT_TRUE(start.found);
  EXPECT_EQ(start.first, 0u);
}

/// What is lost of a series without transient.
TEST(SteadyStart, LosesLittleOfAStationarySeries) {
  struct Case {
    double rho;
    std::size_t n;
  };
  for (Case const c : {Case{0.0, 500}, {0.5, 500}, {0.9, 1000}, {0.9, 4000}, {0.98, 5000}}) {
    Autoregressive source(c.rho, 11);
    int const runs = 300;
    double lost = 0.0;
    int much = 0;
    for (int run = 0; run < runs; ++run) {
      auto const start = steady_start(noise(source, c.n));
      double const share = static_cast<double>(start.first) / static_cast<double>(c.n);
      lost += share / runs;
      much += share > 0.25;
      EXPECT_LE(share, 0.5);
    }
    SCOPED_TRACE(testing::Message() << "rho = " << c.rho << ", n = " << c.n);
    EXPECT_LT(lost, 0.10);
    EXPECT_LT(much, runs / 6);
    RecordProperty("lost", std::to_string(lost));
    std::cout << "rho " << c.rho << " n " << c.n << ": " << lost << " lost, more than a quarter in " << much
              << " of " << runs << "\n";
  }
}

/// Exponential and algebraic transients under noise of known correlation: what is left of the
/// transient is below the error of the mean, and that error covers the truth as often as it says.
TEST(SteadyStart, LeavesMeansAndErrorsRight) {
  std::size_t const n = 4000;
  for (bool const algebraic : {false, true})
    for (double const rho : {0.0, 0.8}) {
      Autoregressive source(rho, 17);
      int const runs = 300;
      int covered = 0;
      double mean = 0.0;
      for (int run = 0; run < runs; ++run) {
        auto series = noise(source, n);
        for (std::size_t k = 0; k < n; ++k) {
          double const t = static_cast<double>(k);
          series[k] += algebraic ? 20 * std::pow(1 + t / 20, -2.0) : 20 * std::exp(-t / 50);
        }
        auto const start = steady_start(series);
        EXPECT_TRUE(start.found);
        EXPECT_GT(start.first, 50u);  // there the transient is still 7 and 1.6 standard deviations
        Estimate const found = estimate(windows_of(series), start.first, identity);
        ASSERT_TRUE(found.error);
        covered += std::abs(*found.mean) < *found.error;
        mean += *found.mean / runs;
      }
      SCOPED_TRACE(testing::Message() << (algebraic ? "algebraic" : "exponential") << ", rho = " << rho);
      // of the algebraic one 20 (1 + t/20)^-2 is left, 400 / (20 + d) / (n - d) in the mean
      EXPECT_LT(std::abs(mean), 0.8 * source.error_of_mean(n));
      EXPECT_GT(static_cast<double>(covered) / runs, algebraic ? 0.50 : 0.60);
      std::cout << "algebraic " << algebraic << " rho " << rho << ": bias " << mean / source.error_of_mean(n)
                << " errors, coverage " << static_cast<double>(covered) / runs << "\n";
    }
}

}  // namespace
}  // namespace bagnold::statistics
