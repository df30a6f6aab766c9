// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/analysis/fit/line.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/analysis/random.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

std::string own_y(std::string const& x) {
  return x == "disks.elasticity" ? "Z/shear.strain_rate" : "B_p_el";
}

/// value = {place where the lines meet}; lines from their outer ends to a little beyond it, those
/// that pass each other as far as their points. A place between two points is drawn from where it
/// may lie as points are resampled: that alone does not move it.
FitResult meet(Points const& measured, Request const& request, Draw const& draw) {
  auto const points = with_logarithms(measured, request.log_x, request.log_y);
  double const at = request.split ? (request.log_x ? std::log(*request.split) : *request.split) : 0;
  auto lines = fit_two_lines(points, request.split ? &at : nullptr);
  if (lines.step && draw.replica != 0)
    lines.meeting.x += std::sqrt(12.0) * lines.meeting.error * random_offset(draw, "step");
  auto const back = [](double value, bool logarithm) {
    return logarithm ? std::exp(value) : value;
  };
  double const place = back(lines.meeting.x, request.log_x), scale = request.log_x ? place : 1.0;
  FitResult out{{place},
                {lines.meeting.error * scale},
                lines.first.chi2 + lines.second.chi2,
                lines.first.freedom + lines.second.freedom,
                points.size()};
  out.weighted = points.weighted();
  out.step = lines.step;
  if (!lines.step) out.grid = {grid_error(points, lines.meeting.x) * scale};
  double const beyond = 0.05 * (points.x.back() - points.x.front());
  auto const add = [&](Fit const& fit, double low, double high) {
    if (!lines.step) {
      low = std::min(low, lines.meeting.x - beyond);
      high = std::max(high, lines.meeting.x + beyond);
    }
    auto line =
        sample_line(low, high, false, [&](double x) { return fit.value[0] + fit.value[1] * x; });
    for (double& x : line.x) x = back(x, request.log_x);
    for (double& y : line.y) y = back(y, request.log_y);
    out.lines.push_back(std::move(line));
  };
  // the right one first: lines one after another to the right are drawn as one
  add(lines.second, points.x[lines.split], points.x.back());
  add(lines.first, points.x.front(), points.x[lines.split - 1]);
  return out;
}

}  // namespace

std::vector<Outcome> find_transitions(SweepTable const& table, Request const& request,
                                      std::vector<Series>& series) {
  if (request.log_x && request.split && !(*request.split > 0.0))
    throw InputError(fmt::format("--split {} (must be above 0 with --log-x)", *request.split));
  auto const x = or_else(request.x, "disks.elasticity");
  series = make_differences(table, request, x, or_else(request.y, own_y(x)));
  std::vector<Task> tasks;
  for (std::uint32_t curve = 0; curve < series.size(); ++curve)
    tasks.push_back(
        {series[curve].labels, [=, points = series[curve].points](std::uint32_t replica) {
           auto const drawn = points(replica);
           if (drawn.size() == 0)
             throw InputError(
                 "no point has values at both strain rates; choose them with --rates, or curves "
                 "with --where");
           return meet(drawn, request, {request.seed, replica, curve});
         }});
  return carry_out(tasks, request);
}

Report transition(SweepTable const& table, Request const& request) {
  Report report;
  std::vector<Series> series;
  auto const outcomes = find_transitions(table, request, series);
  auto const x = or_else(request.x, "disks.elasticity");
  auto const name = symbol(x) + "_c";
  report.results = tabulate(outcomes, {name});
  note_fits(report, outcomes, {name});
  note_left_out(report, table, series);
  for (auto const& one : outcomes) {
    auto const curve = caption(one.labels);
    if (one.failure.empty() && one.found.step)
      report.notes.push_back(fmt::format(
          "{}{}the two lines do not meet where they part: it steps between two points, {} is "
          "their middle, {:.4g}, its error their distance over 12^(1/2)",
          curve, curve.empty() ? "" : ": ", name, one.found.value[0]));
    if (!one.failure.empty())
      report.notes.push_back(
          fmt::format("{}{}no {}: {}", curve, curve.empty() ? "" : ": ", name, one.failure));
  }
  Panel panel(report, x, "difference of " + or_else(request.y, own_y(x)), request.log_x,
              request.log_y);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0));
    for (auto const& line : outcomes[k].found.lines) panel.line(curve, line);
    if (outcomes[k].failure.empty())
      panel.point("mark", curve, outcomes[k].found.value[0], outcomes[k].found.error[0], unknown,
                  unknown);
  }
  draw_against_label(report, outcomes, {{0}}, name, name == "Q_c");
  return report;
}

}  // namespace bagnold::analysis
