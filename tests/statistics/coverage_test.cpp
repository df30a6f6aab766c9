// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/statistics/estimate.hpp"
#include "tests/statistics/series.hpp"

namespace bagnold::statistics {
namespace {

/// What many repetitions of one measurement give, relative to the truth.
struct Repeated {
  int runs = 0;
  int given = 0;           ///< runs with an error that is not rough
  int covered = 0;         ///< of these, |mean| < error
  double error = 0.0;      ///< mean of error / true error
  double scatter = 0.0;    ///< standard deviation of the same
  double correlation = 0;  ///< mean of tau / true tau
};

Repeated repeat(double rho, std::size_t n, int runs) {
  Repeated result;
  result.runs = runs;
  Autoregressive series(rho, 20);
  double squares = 0.0;
  for (int run = 0; run < runs; ++run) {
    series.value = series.normal(series.random);
    std::vector<double> values(n);
    for (double& value : values) value = series.next();
    Estimate const found = estimate(windows_of(values), 0, identity);
    if (!found.error || found.rough) continue;
    ++result.given;
    result.covered += std::abs(*found.mean) < *found.error;
    double const relative = *found.error / series.error_of_mean(n);
    result.error += relative;
    squares += relative * relative;
    result.correlation += *found.correlation / series.correlation_time();
  }
  result.error /= result.given;
  result.correlation /= result.given;
  result.scatter = std::sqrt(squares / result.given - result.error * result.error);
  return result;
}

/// Errors right within 4% on average, scatter as stated in estimate.hpp, and 68.3% of the means
/// within one error, less what t-distributed ratios lack (1.5% at 16 blocks), within 4 binomial
/// standard deviations.
TEST(Coverage, OfAutoregressiveSeries) {
  struct Case {
    double rho;
    std::size_t n;
  };
  for (Case const c : {Case{0.0, 200},
                       {0.0, 4000},
                       {0.5, 600},
                       {0.5, 4000},
                       {0.9, 2500},
                       {0.9, 10000},
                       {0.98, 10000}}) {
    int const runs = 400;
    Repeated const found = repeat(c.rho, c.n, runs);
    double const fraction = static_cast<double>(found.covered) / found.given;
    double const tau = (1.0 + c.rho) / (2.0 * (1.0 - c.rho));
    SCOPED_TRACE(testing::Message() << "rho = " << c.rho << ", n = " << c.n);
    EXPECT_GE(found.given, 0.97 * runs);
    EXPECT_NEAR(found.error, 1.0, 0.04);
    EXPECT_NEAR(found.correlation, 1.0, 0.08);
    EXPECT_LT(found.scatter, 1.3 * std::cbrt(tau / static_cast<double>(c.n)));
    EXPECT_NEAR(fraction, 0.675, 4.0 * std::sqrt(0.68 * 0.32 / found.given));
  }
}

/// Alternating series: the end effect is left in, which errs on the safe side.
TEST(Coverage, OfAlternatingSeries) {
  Repeated const found = repeat(-0.4, 2000, 600);
  EXPECT_EQ(found.given, 600);
  EXPECT_GT(found.error, 0.99);
  EXPECT_LT(found.error, 1.08);
}

TEST(Coverage, FarTooShortRunsSeldomGetAnError) {
  EXPECT_LT(repeat(0.98, 200, 500).given, 15);   // 4 tau
  EXPECT_LT(repeat(0.98, 1000, 500).given, 75);  // 20 tau
}

/// Of runs of 24 to 64 correlation times those that end up with 4 to 7 blocks: mean +- 2 errors
/// holds 95.45% or, since a run with too small an error tends to have more blocks, up to 3% more;
/// within 4 binomial standard deviations. Without Student's factor it is 91 to 92%.
TEST(Coverage, OfRoughErrors) {
  for (double const rho : {0.0, 0.5, 0.9}) {
    Autoregressive series(rho, 50);
    int given = 0, covered = 0;
    for (int run = 0; run < 11000; ++run) {
      auto const n = static_cast<std::size_t>((24 + 4 * (run % 11)) * series.correlation_time());
      series.value = series.normal(series.random);
      std::vector<double> values(n);
      for (double& value : values) value = series.next();
      Estimate const found = estimate(windows_of(values), 0, identity);
      if (!found.rough) continue;
      ++given;
      covered += std::abs(*found.mean) < 2.0 * *found.error;
    }
    SCOPED_TRACE(testing::Message() << "rho = " << rho << ", given " << given);
    double const fraction = static_cast<double>(covered) / given;
    double const scatter = std::sqrt(0.95 * 0.05 / given);
    EXPECT_GT(given, 2000);
    EXPECT_GT(fraction, 0.9545 - 4.0 * scatter);
    EXPECT_LT(fraction, 0.985 + 4.0 * scatter);
  }
}

/// A ratio of two correlated averages against the delta method: x = 2 + u, y = 4 + (u + v) / 2 with
/// u, v of known errors e_u, e_v; to first order x/y - 1/2 = (u - (u + v) / 4) / 4.
TEST(Coverage, OfARatioAgainstTheDeltaMethod) {
  auto const f = [](std::span<double const> a) { return a[0] / a[1]; };
  std::size_t const n = 4000;
  Autoregressive u(0.8, 30), v(0.3, 31);
  double const expected = std::hypot(0.75 * u.error_of_mean(n), 0.25 * v.error_of_mean(n)) / 4.0;
  int const runs = 500;
  int covered = 0;
  double relative = 0.0;
  for (int run = 0; run < runs; ++run) {
    Windows windows{2, {}, {}};
    for (std::size_t i = 0; i < n; ++i) {
      double const a = u.next(), b = v.next();
      windows.push_back(std::vector{2.0 + a, 4.0 + 0.5 * (a + b)}, 1.0);
    }
    Estimate const found = estimate(windows, 0, f);
    covered += std::abs(*found.mean - 0.5) < *found.error;
    relative += *found.error / expected / runs;
  }
  EXPECT_NEAR(relative, 1.0, 0.03);
  EXPECT_NEAR(static_cast<double>(covered) / runs, 0.675, 4.0 * std::sqrt(0.68 * 0.32 / runs));
}

}  // namespace
}  // namespace bagnold::statistics
