// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/rate_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bagnold::analysis {
namespace {

/// p = sigma / mu = c gammadot^x exactly, with a relative error on each quantity, at Q = 3.
std::map<std::string, AtTwoRates> power_law(double x, double relative_error) {
  double const rate = 1e-3, q = 3, mu = 0.2;
  std::map<std::string, AtTwoRates> found;
  for (auto const& [stress, factor] : {std::pair("p", 1.0), std::pair("sigma", mu)}) {
    auto const at = [&](double gammadot, double power, double times) {
      double const value = times * factor * std::pow(gammadot, x - power);
      return WithError{value, relative_error * value};
    };
    auto const both = [&](double power, double times) {
      return AtTwoRates{at(rate, power, times), at(rate / 2, power, times)};
    };
    found[stress] = both(0, 1);
    found[std::string("B_") + stress] = both(2, 1);
    found[std::string("eta_") + stress] = both(1, q);
  }
  return found;
}

TEST(RateLimit, IsThatOfThePower) {
  struct Case {
    double x;
    char const* verdict;
  };
  for (auto const& [x, verdict] : {Case{2.0, "Bagnold"}, Case{1.0, "Newton"}, Case{0.0, "neither"},
                                   Case{1.5, "neither"}, Case{2.05, "Bagnold"}}) {
    auto const found = rate_limit(power_law(x, 0.002), 0.05);
    EXPECT_EQ(found.verdict(), verdict) << x;
    for (auto const* stress : {"p", "sigma"})
      EXPECT_NEAR(found.exponents.at(stress).value, x, 1e-12);
    EXPECT_NEAR(found.limits[0].ratios.at("B_p").value, std::pow(2, 2 - x), 1e-12);
    EXPECT_NEAR(found.limits[1].ratios.at("eta_sigma").value, std::pow(2, 1 - x), 1e-12);
  }
}

/// Errors of independent measurements: of the ratio r times (e_1^2 + e_2^2)^(1/2).
TEST(RateLimit, ErrorsAreThoseOfAQuotient) {
  auto const found = rate_limit(power_law(2.0, 0.01), 0.05);
  EXPECT_NEAR(found.limits[0].ratios.at("B_sigma").error, 0.01 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(found.exponents.at("p").error, 0.01 * std::sqrt(2.0) / std::log(2.0), 1e-12);
}

/// A short measurement proves neither, and is told how much longer it takes: (2 e/tolerance)^2.
TEST(RateLimit, IsUndecidedWhereErrorsAreLarge) {
  auto const found = rate_limit(power_law(2.0, 0.1), 0.05);
  EXPECT_EQ(found.verdict(), "undecided");
  EXPECT_EQ(found.limits[0].verdict, Verdict::undecided);
  EXPECT_EQ(found.limits[1].verdict, Verdict::fails);  // a factor two is seen all the same
  EXPECT_NEAR(found.limits[0].longer, 2 * std::pow(2 * 0.1 / 0.05, 2), 1e-9);
  auto unknown = power_law(2.0, 0.001);
  unknown["B_p"].half.error = INFINITY;
  EXPECT_EQ(rate_limit(unknown, 0.05).verdict(), "undecided");
  EXPECT_EQ(rate_limit(unknown, 0.05).limits[0].longer, 1e300);
}

/// One of the two failing is enough.
TEST(RateLimit, NeedsPressureAndShearStress) {
  auto found = power_law(2.0, 0.002);
  found["B_sigma"].half.value *= 1.2;
  EXPECT_EQ(rate_limit(found, 0.05).verdict(), "neither");
}

TEST(RateLimit, NothingMeasuredIsUndecided) {
  auto found = power_law(2.0, 0.002);
  for (auto& [name, one] : found) one = {{NAN, INFINITY}, {NAN, INFINITY}};
  EXPECT_EQ(rate_limit(found, 0.05).verdict(), "undecided");
}

}  // namespace
}  // namespace bagnold::analysis
