// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/fit/fit.hpp"
#include "src/analysis/fit/models.hpp"

namespace bagnold::analysis {

/// Least squares, each point weighted by 1 / error^2, by the method of Levenberg and Marquardt
/// (MINPACK, in Eigen's version). It starts from the three best combinations of the parameters'
/// guesses, with the linear ones solved for each, and keeps the best end. Parameters with a lower
/// bound are fitted as ln(value - bound). Errors are those of the covariance (J^T W J)^-1 at the
/// end.
///
/// Throws InputError: fewer points than free parameters, points that check_points refuses, a name
/// in `fixed` that the model does not have or a value at or below its bound, or no convergence.
Fit fit(Model const& model, Points const& points, Fixed const& fixed = {});

/// Fits from one start. start: all parameters, fixed ones included.
Fit fit_from(Model const& model, Points const& points, Fixed const& fixed,
             std::vector<double> const& start);

}  // namespace bagnold::analysis
