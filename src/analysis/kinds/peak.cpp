// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "src/analysis/fit/line.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

struct Vertex {
  double x, y;
};

/// Vertex of the parabola through three points.
Vertex vertex(std::array<double, 3> const& x, std::array<double, 3> const& y) {
  double const left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
  double const bend = (right - left) / (x[2] - x[0]);
  double const at = (x[0] + x[1]) / 2.0 - left / (2.0 * bend);
  return {at, y[0] + (at - x[0]) * (left + bend * (at - x[1]))};
}

/// Error of the place of a peak from the spacing of the points and the shape of the curve. The
/// shape is tested by the parabola through the points one further out, of a grid twice as wide: its
/// vertex lies elsewhere. Without these points the error is twice that of the grid: the peak may
/// lie anywhere between two points.
double shape_error(Points const& points, std::size_t at, double place) {
  double const grid = grid_error(points, place);
  if (at < 2 || at + 2 >= points.size()) return 2.0 * grid;
  auto const wide = vertex({points.x[at - 2], points.x[at], points.x[at + 2]},
                           {points.y[at - 2], points.y[at], points.y[at + 2]});
  double const off = wide.x - place;
  return std::isfinite(off)
             ? std::hypot(grid, std::min(std::abs(off), 2.0 * std::sqrt(12.0) * grid))
             : 2.0 * grid;
}

/// value = {place, height}: of the parabola through the highest point and its neighbours, errors of
/// the three carried over to first order, and that of the shape. Parabolas are in ln x for `log_x`.
FitResult highest(Points const& measured, bool log_x) {
  auto const points = with_logarithms(measured, log_x, false);
  check_points(points, 3, "peak");
  auto const at = std::ranges::max_element(points.y) - points.y.begin();
  if (at == 0 || at + 1 == std::ssize(points.y))
    throw InputError("the highest point is the first or the last; add points beyond it");
  auto const first = static_cast<std::size_t>(at - 1);
  check_distinct(part(measured, first, first + 3), "peak");
  std::array<double, 3> x{}, y{};
  std::copy_n(points.x.begin() + at - 1, 3, x.begin());
  std::copy_n(points.y.begin() + at - 1, 3, y.begin());
  auto const best = vertex(x, y);
  FitResult out{{best.x, best.y}, {0.0, 0.0}};
  out.points = points.size();
  for (std::size_t k = 0; k < 3; ++k) {
    auto moved = y;
    double const error = points.weighted() ? points.error[first + k] : unknown;
    constexpr double small = 1e-4;  // of the error: to first order
    moved[k] += small * error;
    auto const then = vertex(x, moved);
    out.error[0] = std::hypot(out.error[0], (then.x - best.x) / small);
    out.error[1] = std::hypot(out.error[1], (then.y - best.y) / small);
  }
  out.grid = {shape_error(points, static_cast<std::size_t>(at), best.x), 0.0};
  if (log_x) {
    double& place = out.value[0];
    place = std::exp(place);
    out.error[0] *= place;
    out.grid[0] *= place;
  }
  return out;
}

}  // namespace

Report peak(SweepTable const& table, Request const& request) {
  auto const x = or_else(request.x, "disks.packing_fraction"), y = or_else(request.y, "spin_var");
  Report report;
  auto const series = make_series(table, request, x, y);
  bool const log_x =
      covers_decades(x) && std::ranges::all_of(series, [](auto const& one) {
        return std::ranges::all_of(one.points(0).x, [](double at) { return at > 0; });
      });
  std::vector<Task> tasks;
  for (auto const& one : series)
    tasks.push_back({one.labels, [points = one.points, log_x](std::uint32_t replica) {
                       return highest(points(replica), log_x);
                     }});
  auto const outcomes = carry_out(tasks, request);
  std::vector<std::string> const names{symbol(x) + "_peak", y + "_peak"};
  report.results = tabulate(outcomes, names);
  note_fits(report, outcomes, names);
  note_left_out(report, table, series);
  Panel panel(report, x, y, log_x, false);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0), series[k].x_error);
    if (outcomes[k].failure.empty())
      panel.point("mark", curve, outcomes[k].found.value[0], outcomes[k].found.error[0],
                  outcomes[k].found.value[1], unknown);
  }
  draw_against_label(report, outcomes, {{0}}, names[0], false);
  return report;
}

}  // namespace bagnold::analysis
