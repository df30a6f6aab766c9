// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/chance.hpp"

#include <cmath>

namespace bagnold::analysis {

double chance_limit(double freedom, double deviations) {
  double const variance = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - variance + deviations * std::sqrt(variance), 3);
}

double students_factor(double freedom) {
  constexpr double z = 1.959964, z2 = z * z;
  if (freedom < 1.5) return 12.70620 / z;
  if (freedom < 2.5) return 4.302653 / z;
  return 1.0 + (z2 + 1.0) / (4.0 * freedom) +
         ((5.0 * z2 + 16.0) * z2 + 3.0) / (96.0 * freedom * freedom) +
         (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / (384.0 * std::pow(freedom, 3));
}

}  // namespace bagnold::analysis
