// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/fit/fit.hpp"
#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// A continuous line of straight pieces with free breaks: kinks, as in P2 Fig. 22.
///
///     y = a + b x + sum_k c_k max(0, x - x_k)
///
/// value = {a, b, c_1, x_1, c_2, x_2, ...}, breaks in rising order. Least squares over all breaks,
/// found exactly (Hudson, J. Am. Stat. Assoc. 61, 1097 (1966)): for every choice of the gaps
/// between points that hold the breaks the pieces are fitted apart; where they meet in their gaps
/// this is the best curve of that choice, else a break lies on a point. Errors by the covariance at
/// the minimum; they are rough where a break lies within one gap of another or of an end, where the
/// bootstrap is to be preferred.
///
/// `points` in order of x, no two at one x; breaks is 1 or 2. Throws InputError with fewer than
/// 2 + 2 breaks points, or where fewer breaks are exact.
Fit fit_piecewise_linear(Points const& points, std::size_t breaks);

/// Value of the curve at x.
double piecewise_linear(double x, std::vector<double> const& value);

}  // namespace bagnold::analysis
