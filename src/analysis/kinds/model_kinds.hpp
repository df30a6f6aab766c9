// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "src/analysis/outcome.hpp"
#include "src/analysis/series.hpp"

namespace bagnold::analysis {

using ModelOf = std::function<Model(Points const&)>;

/// Fits a model to each series, once and for each resampling (from the first fit's end).
std::vector<Outcome> fit_all(std::vector<Series> const& series, ModelOf const& model,
                             Fixed const& fixed, bool log_x, Request const& request);

/// Names of a model's parameters.
std::vector<std::string> names_of(Model const& model);

}  // namespace bagnold::analysis
