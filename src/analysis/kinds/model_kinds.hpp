// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "src/analysis/fit/models.hpp"
#include "src/analysis/outcome.hpp"
#include "src/analysis/series.hpp"

namespace bagnold::analysis {

using ModelOf = std::function<Model(Points const&)>;

/// Fits a model to each series, once and for each resampling (from the first fit's end).
///
/// Where chi2 is beyond chance the law is taken to be off by a share m of y at each point: errors
/// become (error^2 + m^2 y^2)^(1/2), m such that chi2 equals its degrees of freedom (Mandel and
/// Paule, Anal. Chem. 42, 1194 (1970)). Else the points of smallest errors, where the law is no
/// better than elsewhere, would decide alone. FitResult::chi2 is that of the errors as measured.
///
/// Points of a series that weigh alike (Series::alike) are fitted in ln y without their errors;
/// those of the parameters come from the scatter about the fit, which is the misfit then.
std::vector<Outcome> fit_all(std::vector<Series> const& series, ModelOf const& model,
                             Fixed const& fixed, bool log_x, Request const& request);

/// Names of a model's parameters.
std::vector<std::string> names_of(Model const& model);

}  // namespace bagnold::analysis
