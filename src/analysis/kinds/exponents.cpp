// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/analysis/fit/line.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

/// Slope of ln y against ln x over points first .. last - 1 (all: last = 0); value = {x at the
/// middle of ln x, slope}.
FitResult slope(Points const& measured, std::size_t first, std::size_t last) {
  auto const all = with_logarithms(measured, true, true);
  auto const points = part(all, first, last == 0 ? all.size() : last);
  auto const line = fit_line(points);
  double middle = 0.0;
  for (double const x : points.x) middle += x / static_cast<double>(points.size());
  FitResult out{{std::exp(middle), line.value[1]},
                {0.0, line.error[1]},
                line.chi2,
                line.freedom,
                points.size()};
  out.weighted = points.weighted();
  out.lines.push_back(
      sample_line(std::exp(points.x.front()), std::exp(points.x.back()), true,
                  [&](double x) { return std::exp(line.value[0] + line.value[1] * std::log(x)); }));
  return out;
}

std::vector<Task> tasks_of(Series const& series, std::size_t window) {
  std::vector<Task> tasks;
  auto const add = [&](std::string const& name, std::size_t first, std::size_t last) {
    auto labels = series.labels;
    labels.emplace_back("window", name);
    tasks.push_back({labels, [=, points = series.points](std::uint32_t replica) {
                       return slope(points(replica), first, last);
                     }});
  };
  add("all", 0, 0);
  auto const count = series.points(0).size();
  for (std::size_t first = 0; first + window <= count; ++first)
    add(fmt::format("{}", first + 1), first, first + window);
  return tasks;
}

}  // namespace

Report exponents(SweepTable const& table, Request const& request) {
  auto const x = or_else(request.x, "phi_J-phi"), y = or_else(request.y, "B_p");
  if (request.window < 2)
    throw InputError(fmt::format("--window {} (must be at least 2 points)", request.window));
  Report report;
  auto const series = make_series(table, request, x, y);
  std::vector<Task> tasks;
  for (auto const& one : series)
    for (auto& task : tasks_of(one, request.window)) tasks.push_back(std::move(task));
  auto const outcomes = carry_out(tasks, request);
  report.results = tabulate(outcomes, {"x", "exponent"});
  note_fits(report, outcomes, {"x", "exponent"});
  note_left_out(report, table, series);
  Panel above(report, x, y, true, true);
  for (auto const& one : series) above.data(caption(one.labels), one.points(0), one.x_error);
  for (auto const& one : outcomes)
    if (one.labels.back().second == "all")
      for (auto const& line : one.found.lines) above.line(caption(one.labels, "window"), line);
  Panel below(report, x, "exponent", true, false);
  for (auto const& one : outcomes)
    if (one.labels.back().second != "all" && one.failure.empty())
      below.point("data", caption(one.labels, "window"), one.found.value[0], unknown,
                  one.found.value[1], one.found.error[1]);
  return report;
}

}  // namespace bagnold::analysis
