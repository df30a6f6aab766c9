// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"

namespace bagnold::analysis {

void check_points(Points const& points, std::size_t fewest, std::string_view what) {
  auto const n = points.size();
  if (n < fewest)
    throw InputError(
        fmt::format("{}: {} points (must be at least {}); add points to the sweep, or "
                    "fix parameters",
                    what, n, fewest));
  if (points.y.size() != n || (points.weighted() && points.error.size() != n))
    throw std::logic_error("points: x, y and error differ in length");
  auto const finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(points.x, finite) || !std::ranges::all_of(points.y, finite))
    throw InputError(fmt::format("{}: a point is not finite; leave it out", what));
  if (!std::ranges::all_of(points.error, [](double e) { return std::isfinite(e) && e > 0.0; }))
    throw InputError(fmt::format("{}: an error is not above 0; leave the point out", what));
  auto const [least, most] = std::ranges::minmax(points.x);
  if (least == most)
    throw InputError(fmt::format("{}: all points lie at x = {}; vary x in the sweep", what, least));
}

void check_distinct(Points const& points, std::string_view what) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points.x[i] > points.x[i - 1]))
      throw InputError(
          fmt::format("{}: two points at x = {}; tell them apart with --by", what, points.x[i]));
}

Points with_logarithms(Points const& points, bool log_x, bool log_y) {
  Points out = points;
  auto const logarithm = [](double& value, char const* axis) {
    if (!(value > 0.0))
      throw InputError(fmt::format(
          "{} = {} has no logarithm; leave --log-{} out, or narrow --range", axis, value, axis));
    value = std::log(value);
  };
  if (log_x)
    for (double& x : out.x) logarithm(x, "x");
  if (log_y)
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (out.weighted()) out.error[i] /= std::abs(out.y[i]);
      logarithm(out.y[i], "y");
    }
  return out;
}

double grid_error(Points const& points, double x) {
  double width = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (x >= points.x[i] && x <= points.x[i + 1])
      width = std::max(width, points.x[i + 1] - points.x[i]);
  return width / (2.0 * std::sqrt(12.0));
}

}  // namespace bagnold::analysis
