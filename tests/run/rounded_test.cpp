// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/rounded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bagnold {
namespace {

TEST(Rounded, HasTheDigitsOfTheError) {
  EXPECT_EQ(rounded(18900, 1000), "1.89(10)e4");
  EXPECT_EQ(rounded(3.14159, 0.02), "3.14(2)");
  EXPECT_EQ(rounded(3.14159, 0.0149), "3.142(15)");
  EXPECT_EQ(rounded(2.5e-5, 3e-7), "2.50(3)e-5");
  EXPECT_EQ(rounded(-2.5e-5, 3e-7), "-2.50(3)e-5");
  EXPECT_EQ(rounded(0.0123, 0.00098), "0.0123(10)");
  EXPECT_EQ(rounded(0.0123, 0.0006), "0.0123(6)");
  EXPECT_EQ(rounded(1234, 7), "1234(7)");
  EXPECT_EQ(rounded(1234, 70), "1.23(7)e3");
  EXPECT_EQ(rounded(3163, 271), "3.2(3)e3");
  EXPECT_EQ(rounded(99996, 10), "9.9996(10)e4");
  EXPECT_EQ(rounded(99999.6, 1), "9.99996(10)e4");
  EXPECT_EQ(rounded(99999.96, 1), "1.000000(10)e5");
}

TEST(Rounded, ErrorsAboveTheMean) {
  EXPECT_EQ(rounded(0.002, 0.05), "0.00(5)");
  EXPECT_EQ(rounded(3, 40), "0(4)e1");
  EXPECT_EQ(rounded(2e-6, 5e-5), "0(5)e-5");
  EXPECT_EQ(rounded(0, 0.02), "0.00(2)");
  EXPECT_EQ(rounded(0, 2e-9), "0(2)e-9");
}

TEST(Rounded, WithoutAnError) {
  double const none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rounded(3.14159, none), "3.142");
  EXPECT_EQ(rounded(3.14159, 0), "3.142");
  EXPECT_EQ(rounded(none, 1), "undefined");
}

/// What is written is the mean within half of its last digit, which is less than the error.
TEST(Rounded, LosesLessThanTheError) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> power(-12, 12), share(-3, 0.5), sign(-1, 1);
  for (int k = 0; k < 20000; ++k) {
    double const mean = std::copysign(std::pow(10, power(random)), sign(random));
    double const error = std::abs(mean) * std::pow(10, share(random));
    auto const text = rounded(mean, error);
    auto const open = text.find('('), close = text.find(')');
    double const read = std::stod(text.substr(0, open) + text.substr(close + 1));
    EXPECT_LT(std::abs(read - mean), 0.52 * error) << text << " " << mean << " " << error;
  }
}

}  // namespace
}  // namespace bagnold
