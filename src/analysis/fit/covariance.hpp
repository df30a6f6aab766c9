// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace bagnold::analysis {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What a least-squares fit found. Parameters that the data do not tell have the error `unknown`.
struct Fit {
  std::vector<double> value, error;  ///< [parameters]; error 0 where a parameter was fixed
  Eigen::MatrixXd covariance;        ///< [parameters][parameters]
  double chi2 = 0.0;                 ///< sum over points of (residual / error)^2
  std::size_t freedom = 0;           ///< points less free parameters
};

/// (J^T W J)^-1 of the weighted Jacobian W^(1/2) J [n][parameters], by singular values. Directions
/// whose singular value, columns scaled to length 1, is below 1e-8 of the largest are left out; the
/// parameters that have a part in them get the variance `unknown`.
Eigen::MatrixXd covariance_of(Eigen::MatrixXd const& weighted_jacobian);

/// Fills in covariance and errors; without errors of the points the covariance is scaled by
/// chi2 / freedom (unknown with no freedom left).
void set_covariance(Fit& fit, Eigen::MatrixXd const& weighted_jacobian, bool weighted);

}  // namespace bagnold::analysis
