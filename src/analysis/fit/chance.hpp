// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold::analysis {

/// Normal numbers exceeded by chance once in a hundred, and once in a thousand.
inline constexpr double once_in_100 = 2.3263, once_in_1000 = 3.0902;

/// chi2 that is exceeded as rarely as a normal number exceeds `deviations`, by the cube of one
/// (Wilson and Hilferty, Proc. Natl. Acad. Sci. 17, 684 (1931)): 1% low at one degree of freedom.
double chance_limit(double freedom, double deviations = once_in_100);

/// Student's t over the normal number, at 95%: a standard error from the scatter of n values is
/// widened by it (freedom = n - 1) so that twice the error holds the truth as often as of a known
/// error. 6.48 for two values, 2.20 for three, 1.42 for five. Cornish and Fisher's series from
/// three degrees of freedom on (Abramowitz and Stegun 26.7.5), within 1%.
double students_factor(double freedom);

}  // namespace bagnold::analysis
