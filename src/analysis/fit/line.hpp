// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/fit/fit.hpp"
#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// y = intercept + slope x by weighted least squares; value = {intercept, slope}. Without errors of
/// the points the covariance comes from their scatter. Throws InputError as check_points does.
Fit fit_line(Points const& points);

/// Crossing of two lines, and its error to first order from both covariances, taken as independent.
struct Meeting {
  double x, error;
};
Meeting intersection(Fit const& first, Fit const& second);

/// Two straight lines, one for the points up to a split and one for those beyond it, each with two
/// points at least (three where there are six points or more); the split with the least chi2 is
/// taken, or the first point beyond `at` starts the second line. As P2 App. A and the dashed lines
/// of P2 Figs. 32 and 33: where they meet, a difference of two strain rates leaves zero.
///
/// Lines that meet more than one point away from the gap at the split pass each other: y steps
/// between two points, two points being enough for either line then. The place is the middle of
/// that gap, anywhere in which it may lie: its error is the width / 12^(1/2).
struct TwoLines {
  Fit first, second;
  std::size_t split;  ///< index of the first point of the second line
  Meeting meeting;
  bool step = false;  ///< the lines pass each other, `meeting` is the middle of the gap
};

/// `points` in order of x. Throws InputError with fewer than 4 points, or lines that do not meet
/// near their split and are not three errors apart there either.
TwoLines fit_two_lines(Points const& points, double const* at = nullptr);

/// Points first .. last - 1.
Points part(Points const& points, std::size_t first, std::size_t last);

}  // namespace bagnold::analysis
