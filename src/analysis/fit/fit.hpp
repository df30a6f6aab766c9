// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace bagnold::analysis {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Values of parameters that are not fitted.
using Fixed = std::map<std::string, double>;

/// Result of a least-squares fit. Parameters that the data do not determine have the error
/// `unknown`.
struct Fit {
  std::vector<double> value, error;  ///< [parameters]; error 0 where a parameter was fixed
  std::vector<double> covariance;    ///< [parameters][parameters]
  double chi2 = 0.0;                 ///< sum over points of (residual / error)^2
  std::size_t freedom = 0;           ///< points less free parameters
};

}  // namespace bagnold::analysis
