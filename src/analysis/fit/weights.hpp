// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// y / error and 1 / error; 1 / error is 1 where the points have no errors.
Eigen::VectorXd weighted_values(Points const& points);
Eigen::VectorXd weights(Points const& points);

}  // namespace bagnold::analysis
