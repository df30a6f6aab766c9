// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bagnold {
namespace {

/// 113 bits, by the compiler's own library.
#ifdef __SIZEOF_FLOAT128__
using Quad = __float128;
#else
using Quad = long double;  // as on AArch64
static_assert(std::numeric_limits<Quad>::digits == 113);
#endif

Quad quad(DoubleDouble const& a) { return static_cast<Quad>(a.high) + a.low; }

/// |a - b| as a share of b.
double off(DoubleDouble const& a, Quad b) {
  Quad const difference = quad(a) - b;
  return static_cast<double>((difference < 0 ? -difference : difference) / (b < 0 ? -b : b));
}

void expect_apart(DoubleDouble const& a) {
  EXPECT_EQ(a.high + a.low, a.high) << "low is more than half a last place";
}

TEST(DoubleDouble, HasTwiceTheDigits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1), size(-20, 20);
  auto const any = [&] { return unit(random) * std::exp2(size(random)); };
  for (int k = 0; k < 100000; ++k) {
    double const a = any(), b = any(), c = any();
    DoubleDouble const sum = exact_sum(a, b), product = exact_product(a, b);
    ASSERT_TRUE(quad(sum) == static_cast<Quad>(a) + b);
    ASSERT_TRUE(quad(product) == static_cast<Quad>(a) * b);
    DoubleDouble const ratio = quotient(a, b), more = product * c, total = product + ratio;
    EXPECT_LT(off(ratio, static_cast<Quad>(a) / b), 1e-31);
    EXPECT_LT(off(more, quad(product) * c), 1e-31);
    EXPECT_LT(std::abs(static_cast<double>(quad(total) - (quad(product) + quad(ratio)))),
              1e-31 * std::max(std::abs(product.high), std::abs(ratio.high)));
    for (auto const& value : {sum, product, ratio, more, total}) expect_apart(value);
  }
}

TEST(DoubleDouble, FractionsAreFromZeroToOne) {
  auto const expect = [](DoubleDouble const& of, DoubleDouble const& is) {
    EXPECT_EQ(fraction(of).high, is.high);
    EXPECT_EQ(fraction(of).low, is.low);
  };
  expect({0.25, 0}, {0.25, 0});
  expect({-0.25, 0}, {0.75, 0});
  expect({7, 0}, {0, 0});
  expect({7, 1e-20}, {1e-20, 0});
  expect({7, -1e-20}, {1, -1e-20});
  expect({-7, -1e-20}, {1, -1e-20});
  expect({1e15 + 0.5, 0x1p-60}, {0.5, 0x1p-60});
}

}  // namespace
}  // namespace bagnold
