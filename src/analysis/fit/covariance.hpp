// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "src/analysis/fit/fit.hpp"

namespace bagnold::analysis {

/// (J^T W J)^-1 of the weighted Jacobian W^(1/2) J [n][parameters], by singular values. Directions
/// whose singular value, columns scaled to length 1, is below 1e-8 of the largest are left out; the
/// parameters in these directions get the variance `unknown`.
Eigen::MatrixXd covariance_of(Eigen::MatrixXd const& weighted_jacobian);

/// Fills in covariance and errors; without errors of the points the covariance is scaled by
/// chi2 / freedom (unknown with no freedom left).
void set_covariance(Fit& fit, Eigen::MatrixXd const& weighted_jacobian, bool weighted);

}  // namespace bagnold::analysis
