// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/analysis/fit/piecewise_linear.hpp"
#include "src/analysis/kinds/curved_kink.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

/// value = {x_1, y_1, ...} of the kinks; errors of y are not given: it lies on the curve.
FitResult kinks_of(Points const& measured, Request const& request) {
  auto const points = with_logarithms(measured, request.log_x, request.log_y);
  auto const fitted = fit_piecewise_linear(points, request.kinks);
  auto const x_of = [&](double x) { return request.log_x ? std::exp(x) : x; };
  auto const y_of = [&](double y) { return request.log_y ? std::exp(y) : y; };
  FitResult out{{}, {}, fitted.chi2, fitted.freedom, points.size()};
  out.weighted = points.weighted();
  for (std::size_t k = 3; k < fitted.value.size(); k += 2) {
    double const x = fitted.value[k], place = x_of(x);
    out.value.insert(out.value.end(), {place, y_of(piecewise_linear(x, fitted.value))});
    double const scale = request.log_x ? place : 1.0;
    out.error.insert(out.error.end(), {fitted.error[k] * scale, unknown});
    out.grid.insert(out.grid.end(), {grid_error(points, x) * scale, 0.0});
  }
  auto line = sample_line(points.x.front(), points.x.back(), false,
                          [&](double x) { return piecewise_linear(x, fitted.value); });
  std::ranges::transform(line.x, line.x.begin(), x_of);
  std::ranges::transform(line.y, line.y.begin(), y_of);
  out.lines.push_back(std::move(line));
  return out;
}

/// Notes, for each kink, the curves without it: smooth branches describe their points as well.
void note_none(Report& report, std::vector<Outcome> const& outcomes, Request const& request) {
  for (std::size_t k = 0; k < request.kinks; ++k) {
    std::vector<std::string> curves;
    for (auto const& one : outcomes)
      if (one.failure.empty() && !std::isfinite(one.found.value[2 * k]))
        curves.push_back(caption(one.labels));
    if (curves.empty()) continue;
    auto const list = fmt::format("{}", fmt::join(curves, "; "));  // empty: there is one curve
    report.notes.push_back(fmt::format("no kink {} that smooth branches would not make as well{}{}",
                                       k + 1, list.empty() ? "" : ": ", list));
  }
}

}  // namespace

Report kink(SweepTable const& table, Request const& request) {
  auto const x = or_else(request.x, "disks.packing_fraction"), y = or_else(request.y, "p_el");
  check_direction(request);
  if (request.direction != "both" && !request.curved)
    throw InputError(
        fmt::format("--direction {} (of a kink with --curved alone); add --curved, or "
                    "leave it out",
                    request.direction));
  Report report;
  auto const series = make_series(table, request, x, y);
  std::vector<Task> tasks;
  for (auto const& one : series)
    tasks.push_back({one.labels, [=, points = one.points,
                                  curved = CurvedKinks(request)](std::uint32_t replica) {
                       return request.curved ? curved(points(replica), replica)
                                             : kinks_of(points(replica), request);
                     }});
  auto const outcomes = carry_out(tasks, request);
  std::vector<std::string> names;
  for (std::size_t k = 1; k <= request.kinks; ++k) {
    names.push_back(fmt::format("{}_{}", symbol(x), k));
    names.push_back(fmt::format("{}_{}", y, k));
  }
  report.results = tabulate(outcomes, names);
  note_fits(report, outcomes, names);
  note_left_out(report, table, series);
  note_none(report, outcomes, request);
  Panel panel(report, x, y, request.log_x, request.log_y);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0), series[k].x_error);
    for (auto const& line : outcomes[k].found.lines) panel.line(curve, line);
    auto const& found = outcomes[k].found;
    for (std::size_t place = 0; place < found.value.size(); place += 2)
      panel.point("mark", curve, found.value[place], found.error[place], found.value[place + 1],
                  unknown);
  }
  std::vector<DrawnParameter> places;
  for (std::size_t k = 0; k < request.kinks; ++k) places.push_back({2 * k, names[2 * k]});
  draw_against_label(report, outcomes, places, symbol(x), request.log_x);
  return report;
}

}  // namespace bagnold::analysis
