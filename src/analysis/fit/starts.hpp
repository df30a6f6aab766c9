// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "src/analysis/fit/fit.hpp"
#include "src/analysis/fit/models.hpp"

namespace bagnold::analysis {

/// All combinations of the parameters' guesses, fixed ones at their values, the linear ones solved
/// for each by least squares: {chi2, parameters}, best first. Those that are not finite are left
/// out.
std::vector<std::pair<double, std::vector<double>>> starts(Model const& model, Points const& points,
                                                           Fixed const& fixed);

}  // namespace bagnold::analysis
