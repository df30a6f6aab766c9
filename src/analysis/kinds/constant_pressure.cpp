// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/analysis/fit/crossing.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto rate_key = "shear.strain_rate";

/// value = {place along the curve, y there}: ln p against the place (ln gammadot, or phi) and y
/// against it, straight between neighbours.
FitResult at_pressure(Points const& pressure, Points const& other, double wanted, bool log_x) {
  check_points(pressure, 2, "constant pressure");
  auto const place = where_level(with_logarithms(pressure, log_x, true), std::log(wanted));
  if (!place) throw InputError(fmt::format("p = {} lies outside this curve; add points", wanted));
  double const x = log_x ? std::exp(place->value) : place->value;
  auto const y = at_place(with_logarithms(other, log_x, false), place->value, place->error);
  FitResult out{{x, y ? y->value : unknown},
                {place->error * (log_x ? x : 1.0), y ? y->error : unknown}};
  out.points = pressure.size();
  return out;
}

}  // namespace

Report constant_pressure(SweepTable const& table, Request const& request) {
  if (!request.pressure || !(*request.pressure > 0.0))
    throw InputError("constant-pressure needs --pressure P above 0, in m/tau_e^2; 2e-5 in P2");
  auto const along = or_else(request.along, rate_key), y = or_else(request.y, "mu");
  auto asked = request;
  asked.along = along;
  Report report;
  auto const pressures = make_series(table, asked, along, "p");
  auto const others = make_series(table, asked, along, y);
  bool const log_x = covers_decades(along);
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < pressures.size(); ++k)
    tasks.push_back({pressures[k].labels,
                     [=, p = pressures[k].points, other = others[k].points](std::uint32_t replica) {
                       return at_pressure(p(replica), other(replica), *request.pressure, log_x);
                     }});
  auto const outcomes = carry_out(tasks, request);
  auto const name = symbol(along);
  report.results = tabulate(outcomes, {name, y});
  note_left_out(report, table, pressures);
  draw_against_label(report, outcomes, {{0}}, name, log_x);
  draw_against_label(report, outcomes, {{1}}, y, false);
  Panel panel(report, along, y, log_x, false);
  for (auto const& one : outcomes)
    if (one.failure.empty())
      panel.point("data", caption(one.labels, "disks.packing_fraction"), one.found.value[0],
                  one.found.error[0], one.found.value[1], one.found.error[1]);
  return report;
}

}  // namespace bagnold::analysis
