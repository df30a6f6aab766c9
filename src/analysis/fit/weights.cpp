// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/weights.hpp"

namespace bagnold::analysis {

Eigen::VectorXd weights(Points const& points) {
  Eigen::VectorXd w = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.error.size(); ++i)
    w[static_cast<Eigen::Index>(i)] = 1.0 / points.error[i];
  return w;
}

Eigen::VectorXd weighted_values(Points const& points) {
  auto const n = static_cast<Eigen::Index>(points.size());
  return Eigen::Map<Eigen::VectorXd const>(points.y.data(), n).cwiseProduct(weights(points));
}

}  // namespace bagnold::analysis
