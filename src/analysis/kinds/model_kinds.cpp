// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/kinds/model_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/analysis/fit/levenberg_marquardt.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

Points with_misfit(Points points, double misfit) {
  for (std::size_t k = 0; k < points.error.size(); ++k)
    points.error[k] = std::hypot(points.error[k], misfit * points.y[k]);
  return points;
}

/// m of fit_all; 0 where chi2 is one of chance, or no fit is found on the way.
double misfit_of(Model const& model, Points const& points, Fixed const& fixed,
                 Fit const& first) try {
  FitResult found{{}, {}, first.chi2, first.freedom};
  found.weighted = points.weighted();
  if (!beyond_chance(found)) return 0.0;
  double low = 1e-4, high = 1.0;
  constexpr int halvings = 24;  // of ln m: m to a millionth
  for (int i = 0; i < halvings; ++i) {
    double const middle = std::sqrt(low * high);
    auto const fitted = fit_from(model, with_misfit(points, middle), fixed, first.value);
    (fitted.chi2 > static_cast<double>(first.freedom) ? low : high) = middle;
  }
  return high;
} catch (InputError const&) {
  return 0.0;
}

FitResult found_from(Model const& model, Points const& points, Fit const& fitted, bool log_x) {
  FitResult out{fitted.value, fitted.error, fitted.chi2, fitted.freedom, points.size()};
  out.weighted = points.weighted();
  auto const [low, high] = std::ranges::minmax(points.x);
  out.lines.push_back(
      sample_line(low, high, log_x, [&](double x) { return model.value(x, fitted.value); }));
  return out;
}

}  // namespace

std::vector<Outcome> fit_all(std::vector<Series> const& series, ModelOf const& model,
                             Fixed const& fixed, bool log_x, Request const& request) {
  std::vector<Task> tasks;
  for (auto const& one : series) {
    auto const start = std::make_shared<std::pair<std::vector<double>, double>>();
    tasks.push_back({one.labels, [=, points_of = one.points](std::uint32_t replica) {
                       auto const points = points_of(replica);
                       check_points(points, 2, "fit");  // a model takes its guesses from them
                       auto const curve = model(points);
                       auto& [values, misfit] = *start;
                       double chi2 = 0.0;
                       if (replica == 0) {
                         auto const first = fit(curve, points, fixed);
                         chi2 = first.chi2;
                         misfit = misfit_of(curve, points, fixed, first);
                         values = first.value;
                       }
                       auto found = found_from(
                           curve, points,
                           fit_from(curve, with_misfit(points, misfit), fixed, values), log_x);
                       if (replica == 0) values = found.value;
                       found.chi2 = chi2;
                       found.misfit = misfit;
                       return found;
                     }});
  }
  return carry_out(tasks, request);
}

std::vector<std::string> names_of(Model const& model) {
  std::vector<std::string> out;
  for (auto const& parameter : model.parameters) out.push_back(parameter.name);
  return out;
}

std::vector<Outcome> find_crossovers(SweepTable const& table, Request const& request,
                                     std::vector<Series>& series) {
  series = make_series(table, request, or_else(request.x, "disks.elasticity"),
                       or_else(request.y, "B_p_el"));
  auto found = fit_all(series, crossover_model, request.fixed, true, request);
  return found;
}

Report crossover(SweepTable const& table, Request const& request) {
  Report report;
  std::vector<Series> series;
  auto const outcomes = find_crossovers(table, request, series);
  report.results = tabulate(outcomes, crossover_names);
  note_fits(report, outcomes, crossover_names);
  note_left_out(report, table, series);
  Panel panel(report, or_else(request.x, "disks.elasticity"), or_else(request.y, "B_p_el"), true,
              true);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0), series[k].x_error);
    for (auto const& line : outcomes[k].found.lines) panel.line(curve, line);
  }
  draw_against_label(report, outcomes, {{crossover_place}}, "Q_star", true);
  draw_against_label(report, outcomes, {{3}}, "q", false);
  return report;
}

Report friction_law(SweepTable const& table, Request const& request) {
  Report report;
  auto const x = or_else(request.x, "I"), y = or_else(request.y, "mu");
  auto const series = make_series(table, request, x, y);
  auto const outcomes = fit_all(
      series, [](Points const&) { return friction_law_model(); }, request.fixed, true, request);
  report.results = tabulate(outcomes, names_of(friction_law_model()));
  note_fits(report, outcomes, names_of(friction_law_model()));
  note_left_out(report, table, series);
  Panel panel(report, x, y, true, false);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0), series[k].x_error);
    for (auto const& line : outcomes[k].found.lines) panel.line(curve, line);
  }
  return report;
}

}  // namespace bagnold::analysis
