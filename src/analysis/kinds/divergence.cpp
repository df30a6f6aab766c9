// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "src/analysis/kinds/kinds.hpp"
#include "src/analysis/kinds/model_kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto phi_key = "disks.packing_fraction";

struct Spot {
  double phi, error;
  Outcome const* outcome;
  std::size_t parameter;  ///< the one that is the place

  double place(std::uint32_t replica) const {
    return replica == 0 ? outcome->found.value[parameter]
                        : outcome->replicas.at(replica - 1)[parameter];
  }
};

std::vector<Outcome> find_places(SweepTable const& table, Request const& request,
                                 std::vector<Series>& series) {
  Request first = request;
  first.fixed.clear();
  first.range.reset();  // a range of a divergence is one of phi, and so are its first points
  first.first = 0;
  if (request.x.empty()) first.x = "disks.elasticity";
  if (request.of == "crossover") return find_crossovers(table, first, series);
  if (request.of == "transition") return find_transitions(table, first, series);
  if (request.of != "jump")
    throw InputError(
        fmt::format("--of {} (must be crossover, jump, transition or value)", request.of));
  if (request.y.empty()) first.y = "p_el";
  if (request.direction == "both") first.direction = "down";
  return find_jumps(table, first, series);
}

/// True if places weigh alike. By default they do if the law behind them is not exact: places are
/// then off by the error of the law, which their own errors do not contain.
bool weigh_alike(std::vector<Outcome> const& outcomes, Request const& request) {
  if (request.weigh == "alike") return true;
  if (request.weigh == "errors") return false;
  if (request.weigh != "auto")
    throw InputError(fmt::format("--weigh {} (must be auto, alike or errors)", request.weigh));
  return request.of == "crossover" &&
         std::ranges::any_of(outcomes, [](auto const& one) { return beyond_chance(one.found); });
}

/// Series of places against phi, a curve for each combination of the other labels.
std::vector<Series> places_against_phi(std::vector<Outcome> const& outcomes,
                                       Request const& request) {
  std::size_t const parameter = request.of == "crossover" ? crossover_place : 0;
  std::vector<std::pair<std::vector<Label>, std::vector<Spot>>> curves;
  std::size_t without = 0;
  for (auto const& one : outcomes) {
    auto labels = one.labels;
    auto const phi = std::ranges::find(labels, std::string(phi_key), &Label::first);
    if (phi == labels.end())
      throw InputError(
          "divergence: disks.packing_fraction does not differ between the curves; "
          "vary it in the sweep");
    Spot const spot{std::strtod(phi->second.c_str(), nullptr),
                    one.failure.empty() ? one.found.error[parameter] : unknown, &one, parameter};
    labels.erase(phi);
    auto curve = std::ranges::find(curves, labels, [](auto const& c) { return c.first; });
    if (curve == curves.end()) curve = curves.insert(curves.end(), {labels, {}});
    bool const inside =
        !request.range || (spot.phi >= request.range->first && spot.phi <= request.range->second);
    if (!inside) continue;
    if (std::isfinite(spot.error) && spot.error > 0.0)
      curve->second.push_back(spot);
    else
      ++without;
  }
  std::vector<Series> out;
  for (auto& [labels, spots] : curves) {
    std::ranges::stable_sort(spots, {}, &Spot::phi);
    if (request.first != 0 && request.first < spots.size())
      spots.erase(spots.begin() + static_cast<std::ptrdiff_t>(request.first), spots.end());
    out.push_back({labels, std::vector<double>(spots.size(), unknown),
                   [spots](std::uint32_t replica) {
                     Points points;
                     for (auto const& spot : spots) {
                       points.x.push_back(spot.phi);
                       points.y.push_back(spot.place(replica));
                       points.error.push_back(spot.error);
                     }
                     return points;
                   },
                   0});
  }
  out.front().left_out = without;
  return out;
}

}  // namespace

Report divergence(SweepTable const& table, Request const& request) {
  if (auto const twice = request.fixed.find("phi_J"); request.phi_j && twice != request.fixed.end())
    throw InputError(fmt::format("--phi-j {} and --fix phi_J={} (are one parameter); give one",
                                 *request.phi_j, twice->second));
  Report report;
  std::vector<Series> found_on, series;
  std::vector<Outcome> places;
  bool const of_value = request.of == "value";
  if (of_value) {
    if (request.y.empty()) throw InputError("--of value needs --y NAME");
    series = make_series(table, request, or_else(request.x, phi_key), request.y);
  } else {
    places = find_places(table, request, found_on);
    note_left_out(report, table, found_on);
    note_fits(report, places,
              request.of == "crossover" ? crossover_names : std::vector<std::string>{});
    series = places_against_phi(places, request);
  }
  for (auto& one : series) one.alike = weigh_alike(places, request);
  auto fixed = request.fixed;
  if (request.phi_j) fixed["phi_J"] = *request.phi_j;
  auto const outcomes = fit_all(series, divergence_model, fixed, false, request);
  report.results = tabulate(outcomes, {"Q0", "c", "phi_J", "x"});
  note_fits(report, outcomes, {"Q0", "c", "phi_J", "x"});
  note_left_out(report, of_value ? table : SweepTable{}, series);
  Panel panel(report, phi_key,
              of_value                    ? request.y
              : request.of == "crossover" ? "Q_star"
                                          : "Q_c",
              false, true);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0));
    for (auto const& line : outcomes[k].found.lines) panel.line(curve, line);
    if (outcomes[k].failure.empty())
      panel.point("mark", "phi_J", outcomes[k].found.value[2], unknown, unknown, unknown);
  }
  return report;
}

}  // namespace bagnold::analysis
