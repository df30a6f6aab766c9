// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// Area common to two circles of radii R and r whose centres are d apart, [d_s^2].
///
/// Where they cut, the lens is a sum of two segments,
///
///     A = R^2 (a - sin a cos a) + r^2 (b - sin b cos b),
///     cos a = (d^2 + R^2 - r^2)/(2 d R),  cos b = (d^2 + r^2 - R^2)/(2 d r).
double circle_overlap(double R, double r, double d);

/// Area of a circle of radius r below a line at height t above its centre, [d_s^2].
double circle_below(double r, double t);

}  // namespace bagnold
