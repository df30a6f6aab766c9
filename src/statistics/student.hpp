// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace bagnold::statistics {

/// P(|t| <= value) of Student's t with `freedom` degrees of freedom, 1 at least. With
/// theta = atan(value / freedom^(1/2)), Abramowitz and Stegun, Eqs. 26.7.3 and 26.7.4:
///
///     odd:   (2/pi) {theta + sin theta [cos theta + (2/3) cos^3 theta + ...
///                                       + (2 4 .. (freedom - 3))/(3 5 .. (freedom - 2))
///                                         cos^(freedom - 2) theta]}
///     even:  sin theta {1 + (1/2) cos^2 theta + (1 3)/(2 4) cos^4 theta + ...
///                       + (1 3 .. (freedom - 3))/(2 4 .. (freedom - 2)) cos^(freedom - 2) theta}.
double student_probability(double value, std::size_t freedom);

/// Factor on a standard error with `freedom` degrees of freedom that makes mean +- 2 errors the
/// interval of 95.45%, as for an error that is known exactly: half of the value that |t| stays
/// below with the probability erf(2^(1/2)). 2.26, 1.65, 1.43 for 2, 3, 4; 1.21 for 7.
double student_factor(std::size_t freedom);

/// Value that |t| stays below with the probability 0.95: 3.18, 2.57, 2.31 for 3, 5, 8.
double student_quantile(std::size_t freedom);

}  // namespace bagnold::statistics
