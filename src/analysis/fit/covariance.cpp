// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/covariance.hpp"

#include <Eigen/SVD>
#include <cmath>

namespace bagnold::analysis {

Eigen::MatrixXd covariance_of(Eigen::MatrixXd const& weighted_jacobian) {
  constexpr double smallest = 1e-8, part = 1e-3;
  Eigen::VectorXd scale = weighted_jacobian.colwise().norm();
  for (double& length : scale)
    if (!(length > 0.0)) length = 1.0;
  Eigen::MatrixXd const scaled = weighted_jacobian * scale.cwiseInverse().asDiagonal();
  Eigen::JacobiSVD<Eigen::MatrixXd> const svd(scaled, Eigen::ComputeThinU | Eigen::ComputeFullV);
  auto const& singular = svd.singularValues();
  auto const columns = weighted_jacobian.cols();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd untold = Eigen::VectorXd::Zero(columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    Eigen::VectorXd const direction = svd.matrixV().col(k);
    if (k < singular.size() && singular[k] > smallest * singular[0])
      covariance += direction * direction.transpose() / (singular[k] * singular[k]);
    else
      untold = untold.cwiseMax(direction.cwiseAbs());
  }
  covariance = scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
  for (Eigen::Index k = 0; k < columns; ++k)
    if (untold[k] > part) {
      covariance.row(k).setConstant(unknown);
      covariance.col(k).setConstant(unknown);
    }
  return covariance;
}

void set_covariance(Fit& fit, Eigen::MatrixXd const& weighted_jacobian, bool weighted) {
  Eigen::MatrixXd covariance = covariance_of(weighted_jacobian);
  if (!weighted)
    covariance *= fit.freedom == 0 ? unknown : fit.chi2 / static_cast<double>(fit.freedom);
  fit.error.clear();
  for (double const variance : covariance.diagonal()) fit.error.push_back(std::sqrt(variance));
  fit.covariance.assign(covariance.data(), covariance.data() + covariance.size());
}

}  // namespace bagnold::analysis
