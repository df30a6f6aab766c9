// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kernels/physics/multiply_add.hpp"
#include "kernels/physics/vec2.hpp"

/// Sums of power series, accurate to rounding for small arguments. They use no library function, so
/// the bits are the same on every machine.
namespace bagnold::series {

template <class T>
struct SineCosine {
  T sine, cosine;
};

inline constexpr int most_terms = 24;

/// 1/n!
inline constexpr auto inverse_factorial = [] {
  std::array<Real, most_terms> of{};
  Real value = 1;
  for (int n = 0; n < most_terms; of[n++] = value)
    if (n > 1) value /= n;
  return of;
}();

/// To x^(2 terms): |error| < |x|^(2 terms + 1)/(2 terms + 1)!
template <int terms, class T>
SineCosine<T> sine_cosine(T const& x) {
  T const square = -(x * x);
  T sine(inverse_factorial[2 * terms - 1]), cosine(inverse_factorial[2 * terms]);
  for (int k = terms - 1; k >= 0; --k) {
    if (k > 0) sine = multiply_add(square, sine, T(inverse_factorial[2 * k - 1]));
    cosine = multiply_add(square, cosine, T(inverse_factorial[2 * k]));
  }
  return {x * sine, cosine};
}

/// exp(x) - 1, to x^terms.
template <int terms, class T>
T growth(T const& x) {
  T sum(inverse_factorial[terms]);
  for (int k = terms - 1; k > 0; --k) sum = multiply_add(x, sum, T(inverse_factorial[k]));
  return x * sum;
}

}  // namespace bagnold::series
