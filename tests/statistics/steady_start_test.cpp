// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/steady_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "src/statistics/estimate.hpp"
#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

/// The definition, sum by sum: batches of 5, all truncations up to the middle, the earliest of
/// equals.
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
    EXPECT_LT(lost, 0.03);
    EXPECT_LE(much, runs / 50);
  }
}

/// A transient f(t) on noise whose batches of 5 have the standard deviation s is cut where f(d) =
/// s: there -f^2 - s^2 + 2 S/(n - d) = 0, the derivative of S/(n - d)^2 with S = s^2 (n - d). What
/// is left of it biases the mean by F = (1/(n - d)) sum_{t > d} f.
struct Transient {
  std::function<double(double)> at, inverse, sum_after;
};
Transient const exponential{[](double t) { return 20 * std::exp(-t / 50); },
                            [](double f) { return 50 * std::log(20 / f); },
                            [](double t) { return 1000 * std::exp(-t / 50); }};
Transient const algebraic{[](double t) { return 20 * std::pow(1 + t / 20, -2.0); },
                          [](double f) { return 20 * (std::sqrt(20 / f) - 1); },
                          [](double t) { return 400 / (1 + t / 20); }};

double normal_within(double width, double bias) {  // P(|x + bias| < width)
  return (std::erf((width - bias) / std::sqrt(2.0)) + std::erf((width + bias) / std::sqrt(2.0))) /
         2;
}

TEST(SteadyStart, CutsWhereTheTransientIsAsLargeAsTheNoise) {
  std::size_t const n = 4000;
  for (auto const* transient : {&exponential, &algebraic})
    for (double const rho : {0.0, 0.8}) {
      Autoregressive source(rho, 17);
      double const cut = transient->inverse(source.error_of_mean(5));
      double const left = transient->sum_after(cut) / (static_cast<double>(n) - cut);
      double const bias = left / source.error_of_mean(n);
      int const runs = 300;
      int covered = 0;
      double first = 0.0, mean = 0.0;
      for (int run = 0; run < runs; ++run) {
        auto series = noise(source, n);
        for (std::size_t t = 0; t < n; ++t) series[t] += transient->at(static_cast<double>(t));
        auto const start = steady_start(series);
        EXPECT_TRUE(start.found);
        Estimate const found = estimate(windows_of(series), start.first, identity);
        ASSERT_TRUE(found.error);
        covered += std::abs(*found.mean) < *found.error;
        first += static_cast<double>(start.first) / runs;
        mean += *found.mean / runs;
      }
      double const fraction = static_cast<double>(covered) / runs;
      SCOPED_TRACE(testing::Message()
                   << (transient == &algebraic ? "algebraic" : "exponential") << ", rho = " << rho
                   << ": cut " << cut << ", bias in errors " << bias << ", covered " << fraction);
      EXPECT_NEAR(first, cut, 0.25 * cut);
      EXPECT_NEAR(mean, left, 0.35 * left + 3 * source.error_of_mean(n) / std::sqrt(runs));
      EXPECT_GT(fraction, normal_within(1, bias) - 4 * std::sqrt(0.25 / runs));
    }
}

}  // namespace
}  // namespace bagnold::statistics
