// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/crossing.hpp"

#include <cmath>

#include "src/analysis/fit/fit.hpp"

namespace bagnold::analysis {
namespace {

/// Error of (1 - share) y_i + share y_{i+1}.
double interpolation_error(Points const& points, std::size_t i, double share) {
  if (!points.weighted()) return unknown;
  return std::hypot((1.0 - share) * points.error[i], share * points.error[i + 1]);
}

}  // namespace

std::optional<Interpolated> where_level(Points const& points, double level) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    double const before = points.y[i] - level, after = points.y[i + 1] - level;
    if ((before > 0.0) == (after > 0.0) && before != 0.0 && after != 0.0) continue;
    if (before == after) continue;
    double const share = before / (before - after);
    double const width = points.x[i + 1] - points.x[i];
    return Interpolated{points.x[i] + share * width,
                        interpolation_error(points, i, share) * width / std::abs(after - before)};
  }
  return std::nullopt;
}

std::optional<Interpolated> at_place(Points const& points, double x, double x_error) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!(x >= points.x[i] && x <= points.x[i + 1])) continue;
    double const width = points.x[i + 1] - points.x[i], rise = points.y[i + 1] - points.y[i];
    double const share = (x - points.x[i]) / width;
    return Interpolated{points.y[i] + share * rise,
                        std::hypot(interpolation_error(points, i, share), x_error * rise / width)};
  }
  return std::nullopt;
}

}  // namespace bagnold::analysis
