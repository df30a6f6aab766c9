// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/analysis/fit/covariance.hpp"
#include "src/analysis/fit/least_squares.hpp"
#include "src/analysis/fit/weights.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {

Fit fit_line(Points const& points) {
  check_points(points, 2, "straight line");
  auto const n = static_cast<Eigen::Index>(points.size());
  auto const weight = weights(points);
  Eigen::MatrixXd design(n, 2);
  design.col(0) = weight;
  design.col(1) = Eigen::Map<Eigen::VectorXd const>(points.x.data(), n).cwiseProduct(weight);
  auto const [best, chi2] = least_squares(design, weighted_values(points));
  Fit out{{best[0], best[1]}, {}, {}, chi2, points.size() - 2};
  set_covariance(out, design, points.weighted());
  return out;
}

Meeting intersection(Fit const& first, Fit const& second) {
  double const slopes = first.value[1] - second.value[1];
  double const x = (second.value[0] - first.value[0]) / slopes;
  // d x / d intercept = 1 / slopes, d x / d slope = x / slopes, with opposite signs for the two
  Eigen::Vector2d const slope_of_x(1.0 / slopes, x / slopes);
  double variance = 0.0;
  for (auto const* line : {&first, &second})
    variance += slope_of_x.dot(Eigen::Map<Eigen::MatrixXd const>(line->covariance.data(), 2, 2) *
                               slope_of_x);
  return {x, std::sqrt(variance)};
}

Points part(Points const& points, std::size_t first, std::size_t last) {
  auto const cut = [&](std::vector<double> const& all) {
    return all.empty() ? all
                       : std::vector(all.begin() + static_cast<std::ptrdiff_t>(first),
                                     all.begin() + static_cast<std::ptrdiff_t>(last));
  };
  return {cut(points.x), cut(points.y), cut(points.error)};
}

namespace {

TwoLines best_split(Points const& points, std::size_t first, std::size_t last) {
  std::optional<TwoLines> best;
  for (auto split = first; split <= last; ++split) {
    TwoLines now{
        fit_line(part(points, 0, split)), fit_line(part(points, split, points.size())), split, {}};
    if (!best || now.first.chi2 + now.second.chi2 < best->first.chi2 + best->second.chi2)
      best = std::move(now);
  }
  best->meeting = intersection(best->first, best->second);
  auto const low = best->split - 2, high = std::min(best->split + 1, points.size() - 1);
  best->step = !(best->meeting.x >= points.x[low] && best->meeting.x <= points.x[high]);
  return *best;
}

/// Value of a line at x and its error.
Meeting line_at(Fit const& line, double x) {
  Eigen::Vector2d const slope(1.0, x);
  auto const covariance = Eigen::Map<Eigen::MatrixXd const>(line.covariance.data(), 2, 2);
  return {line.value[0] + line.value[1] * x, std::sqrt(slope.dot(covariance * slope))};
}

/// True if the lines are more than three of their errors apart at x. Unknown errors (of two points
/// without errors) count as zero.
bool are_apart(TwoLines const& lines, double x) {
  constexpr double clear = 3.0;
  auto const first = line_at(lines.first, x), second = line_at(lines.second, x);
  auto const known = [](double error) { return std::isfinite(error) ? error : 0.0; };
  return std::abs(first.x - second.x) > clear * std::hypot(known(first.error), known(second.error));
}

}  // namespace

TwoLines fit_two_lines(Points const& points, double const* at) {
  check_points(points, 4, "two lines");
  auto const n = points.size();
  std::size_t const fewest = n >= 6 ? 3 : 2;
  std::size_t first = fewest, last = n - fewest;
  if (at != nullptr) {
    first = last =
        static_cast<std::size_t>(std::ranges::upper_bound(points.x, *at) - points.x.begin());
    if (first < 2 || n - first < 2)
      throw InputError(fmt::format("--split {} leaves a line with fewer than 2 points", *at));
  }
  auto best = best_split(points, first, last);
  if (best.step && at == nullptr) best = best_split(points, 2, n - 2);
  if (!best.step) return best;
  double const before = points.x[best.split - 1], beyond = points.x[best.split];
  double const middle = (before + beyond) / 2.0;
  if (std::isnan(best.meeting.x) || !are_apart(best, middle))
    throw InputError(
        "two lines: they do not meet near where they part; narrow --range or give --split");
  best.meeting = {middle, (beyond - before) / std::sqrt(12.0)};
  return best;
}

}  // namespace bagnold::analysis
