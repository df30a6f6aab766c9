// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/chance.hpp"

#include <cmath>

namespace bagnold::analysis {

double chance_limit(double freedom, double deviations) {
  double const variance = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - variance + deviations * std::sqrt(variance), 3);
}

}  // namespace bagnold::analysis
