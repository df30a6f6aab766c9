// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "kernels/physics/vec2.hpp"

namespace bagnold::events {

/// Order of the Taylor series in time of positions in a cluster, K.
inline constexpr int series_order = 7;

/// Taylor coefficients in time of a number: c_0 + c_1 s + ... + c_K s^K.
using Series = std::array<Real, series_order + 1>;

/// Coefficient k of a product, sum of a_j b_(k-j).
template <int k>
Real product(Series const& a, Series const& b) {
  Real sum = a[0] * b[k];
  for (int j = 1; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

/// Coefficient k of a square.
template <int k>
Real square(Series const& a) {
  Real sum = 0;
  for (int j = 0; 2 * j < k; ++j) sum += a[j] * a[k - j];
  sum += sum;
  if constexpr (k % 2 == 0) sum += a[k / 2] * a[k / 2];
  return sum;
}

/// The sum of a series at a phase, a number or one at each node.
template <class T>
T value(Series const& c, T const& s) {
  T sum(c[series_order]);
  for (int k = series_order - 1; k >= 0; --k) sum = sum * s + T(c[k]);
  return sum;
}

/// Time derivative of the series at s.
template <class T>
T rate(Series const& c, T const& s) {
  T sum(series_order * c[series_order]);
  for (int k = series_order - 1; k > 0; --k) sum = sum * s + T(k * c[k]);
  return sum;
}

/// Bound of the second derivative over a step of a length h, [c / tau_e^2].
inline Real second_rate_bound(Series const& c, Real h) {
  Real sum = 0;
  for (int k = series_order; k > 1; --k) sum = sum * h + k * (k - 1) * std::fabs(c[k]);
  return sum;
}
inline Real second_rate_bound(Series const& x, Series const& y, Real h) {
  Real sum = 0;
  for (int k = series_order; k > 1; --k)
    sum = sum * h + k * (k - 1) * (std::fabs(x[k]) + std::fabs(y[k]));
  return sum;
}

}  // namespace bagnold::events
