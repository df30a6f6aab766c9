// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace bagnold::analysis {

struct Solution {
  Eigen::VectorXd value;  ///< [columns]
  double chi2;            ///< |y - design value|^2
};

/// Solution with the least |y - design value|^2, design [n][columns], by QR with pivots.
Solution least_squares(Eigen::MatrixXd const& design, Eigen::VectorXd const& y);

}  // namespace bagnold::analysis
