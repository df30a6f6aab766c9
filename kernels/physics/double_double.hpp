// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/physics/math.hpp"

namespace bagnold {

/// A number of twice the digits of a double, 106 bits, as the sum of two doubles; |low| is at most
/// half a last place of high. The same bits on every backend. (T. J. Dekker, Numer. Math. 18, 224
/// (1971).)
struct DoubleDouble {
  double high = 0, low = 0;

  /// Rounded once.
  KOKKOS_FUNCTION double rounded() const { return high + low; }
};

/// a + b where |a| >= |b|, exactly.
KOKKOS_INLINE_FUNCTION DoubleDouble sum_of_ordered(double a, double b) {
  double const sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b, exactly.
KOKKOS_INLINE_FUNCTION DoubleDouble exact_sum(double a, double b) {
  double const sum = a + b;
  double const of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a b, exactly.
KOKKOS_INLINE_FUNCTION DoubleDouble exact_product(double a, double b) {
  double const product = a * b;
  return {product, ::fma(a, b, -product)};  // which device code has too
}

/// a / b
KOKKOS_INLINE_FUNCTION DoubleDouble quotient(double a, double b) {
  double const first = a / b;
  return sum_of_ordered(first, ::fma(-first, b, a) / b);
}

KOKKOS_INLINE_FUNCTION DoubleDouble operator+(DoubleDouble const& a, DoubleDouble const& b) {
  DoubleDouble const high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  DoubleDouble const sum = sum_of_ordered(high.high, high.low + low.high);
  return sum_of_ordered(sum.high, sum.low + low.low);
}

KOKKOS_INLINE_FUNCTION DoubleDouble operator*(DoubleDouble const& a, double b) {
  DoubleDouble const product = exact_product(a.high, b);
  return sum_of_ordered(product.high, ::fma(a.low, b, product.low));
}

/// a less the largest whole number that is not above it, in [0, 1).
KOKKOS_INLINE_FUNCTION DoubleDouble fraction(DoubleDouble const& a) {
  double const whole = math::floor(a.high);
  double const more = whole == a.high ? math::floor(a.low) : 0;
  return a + exact_sum(-whole, -more);
}

}  // namespace bagnold
