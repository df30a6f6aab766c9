// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// A value with its standard error; NaN where none is known.
struct Interpolated {
  double value, error;
};

/// x at which the straight lines between neighbours first reach y = level, in order of x, and its
/// error from those of the two neighbours. None where they do not reach it.
std::optional<Interpolated> where_level(Points const& points, double level);

/// y on the straight line between the neighbours of x, and its error: those of the neighbours, and
/// `x_error` times the slope. None outside the points.
std::optional<Interpolated> at_place(Points const& points, double x, double x_error);

}  // namespace bagnold::analysis
