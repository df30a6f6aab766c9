// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/fit/fit.hpp"
#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// Kinks between curved branches: straight between the kinks x_1, ..., x_n, and beyond the first
/// and the last a polynomial.
///
///     y = a + b x + sum_k c_k max(0, x - x_k)
///           + sum_j l_j min(0, x - x_1)^j + sum_j r_j max(0, x - x_n)^j,   j = 2 .. degree
///
/// The degree of a branch of few points is one less than their number.
struct Branches {
  Fit fit;  ///< value = {a, b, c_1, x_1, ..., l_2, ..., r_2, ...}
  std::size_t kinks = 0, left = 0, right = 0;  ///< the latter: degrees of the branches

  double bend(std::size_t k) const { return fit.value[2 + 2 * k]; }  ///< c_k, from k = 0
  double bend_error(std::size_t k) const { return fit.error[2 + 2 * k]; }
  double place(std::size_t k) const { return fit.value[3 + 2 * k]; }
  double place_error(std::size_t k) const { return fit.error[3 + 2 * k]; }

  /// Value of the curve at x.
  double operator()(double x) const;
};

/// Least squares over all places of the kinks: from the best of those on points and midway between
/// them, by golden sections. Either branch has three points at least, two kinks two between them.
/// `points` in order of x, no two at one x. Throws InputError with kinks other than 1 or 2 or too
/// few points.
Branches fit_branches(Points const& points, std::size_t kinks, std::size_t left_degree,
                      std::size_t right_degree);

/// Least-squares polynomial with a number of parameters: of T_0, T_1, ... (Chebyshev) over the
/// range of x.
Fit fit_polynomial(Points const& points, std::size_t parameters);

}  // namespace bagnold::analysis
