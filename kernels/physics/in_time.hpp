// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

#include "kernels/physics/multiply_add.hpp"

namespace bagnold {

/// Polynomial in time t of a fixed degree, c_0 + c_1 t + .., as of a disk in free flight. Formulas
/// written for numbers hold for whole flights: the degree of a product is the sum of those of its
/// factors, so nothing is cut off and nothing multiplied by zero. T: a number or a pack.
template <class T, int degree>
struct InTime {
  T c[degree + 1]{};

  /// Sum over many times, from their number, the sum of t and the sum of t^2.
  KOKKOS_FORCEINLINE_FUNCTION T over(T const& times, T const& sum_t, T const& sum_t2) const {
    static_assert(degree <= 2);
    T const powers[3] = {times, sum_t, sum_t2};
    T total = c[0] * powers[0];
    for (int k = 1; k <= degree; ++k) total = multiply_add(c[k], powers[k], total);
    return total;
  }

  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION InTime& operator+=(InTime<T, d> const& b) {
    static_assert(d <= degree);
    for (int k = 0; k <= d; ++k) c[k] += b.c[k];
    return *this;
  }
  KOKKOS_FORCEINLINE_FUNCTION InTime& operator+=(T const& b) {
    c[0] += b;
    return *this;
  }
};

template <class T>
using Linear = InTime<T, 1>;
template <class T>
using Quadratic = InTime<T, 2>;

template <class T, int p, int q>
KOKKOS_FORCEINLINE_FUNCTION InTime<T, p + q> operator*(InTime<T, p> const& a,
                                                       InTime<T, q> const& b) {
  InTime<T, p + q> product;
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) product.c[i + j] = multiply_add(a.c[i], b.c[j], product.c[i + j]);
  return product;
}

template <class T, int p>
KOKKOS_FORCEINLINE_FUNCTION InTime<T, p> operator*(T const& a, InTime<T, p> const& b) {
  InTime<T, p> product;
  for (int k = 0; k <= p; ++k) product.c[k] = a * b.c[k];
  return product;
}

template <class T, int p>
KOKKOS_FORCEINLINE_FUNCTION InTime<T, p> operator*(InTime<T, p> const& a, T const& b) {
  return b * a;
}

}  // namespace bagnold
