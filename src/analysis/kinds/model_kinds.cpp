// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/kinds/model_kinds.hpp"

#include <fmt/format.h>

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

/// A misfit that no point would show: a tenth of the smallest relative error.
double least_misfit(Points const& points) {
  double least = 1e-4;
  for (std::size_t k = 0; k < points.error.size(); ++k)
    if (points.y[k] != 0.0) least = std::min(least, 0.1 * points.error[k] / std::abs(points.y[k]));
  return least;
}

/// m of fit_all; 0 where chi2 is one of chance, or no fit is found on the way.
double misfit_of(Model const& model, Points const& points, Fixed const& fixed,
                 Fit const& first) try {
  FitResult found{{}, {}, first.chi2, first.freedom};
  found.weighted = points.weighted();
  if (!beyond_chance(found)) return 0.0;
  double low = least_misfit(points), high = 1.0;
  constexpr int halvings = 25;  // of ln m: m to a millionth
  for (int i = 0; i < halvings; ++i) {
    double const middle = std::sqrt(low * high);
    auto const fitted = fit_from(model, with_misfit(points, middle), fixed, first.value);
    (fitted.chi2 > static_cast<double>(first.freedom) ? low : high) = middle;
  }
  return high;
} catch (InputError const&) {
  return 0.0;
}

/// Start of the fits of a series: found on the measured points.
struct Start {
  std::vector<double> value;
  double chi2 = 0.0, misfit = 0.0;
};

/// ln y, of no errors: all weigh the same.
Points in_logarithms(Points const& points) {
  auto out = with_logarithms(points, false, true);
  out.error.clear();
  return out;
}

Fit fit_weighing(bool alike, Model const& model, Points const& points, Fixed const& fixed,
                 Start const& start) {
  if (alike) return fit_from(logarithm_of(model), in_logarithms(points), fixed, start.value);
  return fit_from(model, with_misfit(points, start.misfit), fixed, start.value);
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
    auto const start = std::make_shared<Start>();
    tasks.push_back(
        {one.labels, [=, points_of = one.points, alike = one.alike](std::uint32_t replica) {
           auto const points = points_of(replica);
           check_points(points, 2, "fit");  // a model takes its guesses from them
           auto const curve = model(points);
           if (replica == 0) {
             auto const first = fit(curve, points, fixed);
             *start = {first.value, first.chi2,
                       alike ? 0.0 : misfit_of(curve, points, fixed, first)};
           }
           auto const fitted = fit_weighing(alike, curve, points, fixed, *start);
           auto found = found_from(curve, points, fitted, log_x);
           if (replica == 0) start->value = found.value;
           found.chi2 = start->chi2;
           found.alike = alike;
           found.misfit = start->misfit;
           if (alike && fitted.freedom != 0)
             found.misfit = std::sqrt(fitted.chi2 / static_cast<double>(fitted.freedom));
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

namespace {

/// Removes exponents q that an inexact law does not determine, and says so. q follows from x far
/// beyond Q*: it is removed where x reaches less than a decade beyond and chi2 of any curve is
/// beyond chance.
void leave_out_exponents(Report& report, std::vector<Outcome>& outcomes,
                         std::vector<Series> const& series) {
  constexpr double decade = 10.0;
  constexpr std::size_t exponent = 3;
  if (std::ranges::none_of(outcomes, [](auto const& one) { return beyond_chance(one.found); }))
    return;
  std::string list;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    auto& [labels, found, failure, replicas, bootstrap] = outcomes[k];
    if (!failure.empty() || found.error[exponent] == 0.0) continue;
    double const reach = series[k].points(0).x.back() / found.value[crossover_place];
    if (reach >= decade) continue;
    found.value[exponent] = found.error[exponent] = bootstrap[exponent] = unknown;
    list += fmt::format("{}{}to {:.2g} Q_star", list.empty() ? "" : "; ",
                        labels.empty() ? "" : caption(labels) + ", ", reach);
  }
  if (!list.empty())
    report.notes.push_back(fmt::format(
        "no q ({}): the law is not exact, so the range of x decides q where it goes less than a "
        "decade beyond Q_star",
        list));
}

}  // namespace

Report crossover(SweepTable const& table, Request const& request) {
  Report report;
  std::vector<Series> series;
  auto outcomes = find_crossovers(table, request, series);
  leave_out_exponents(report, outcomes, series);
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
