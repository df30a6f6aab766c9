// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/least_squares.hpp"

#include <Eigen/QR>

namespace bagnold::analysis {

Solution least_squares(Eigen::MatrixXd const& design, Eigen::VectorXd const& y) {
  Eigen::VectorXd const value = design.colPivHouseholderQr().solve(y);
  return {value, (y - design * value).squaredNorm()};
}

}  // namespace bagnold::analysis
