// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold::analysis {

/// Normal numbers exceeded by chance once in a hundred, and once in a thousand.
inline constexpr double once_in_100 = 2.3263, once_in_1000 = 3.0902;

/// chi2 that is exceeded as rarely as a normal number exceeds `deviations`, by the cube-root
/// approximation (Wilson and Hilferty, Proc. Natl. Acad. Sci. 17, 684 (1931)): 1% low at one degree
/// of freedom.
double chance_limit(double freedom, double deviations = once_in_100);

}  // namespace bagnold::analysis
