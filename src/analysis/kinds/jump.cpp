// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/jump.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/analysis/kinds/kinds.hpp"
#include "src/analysis/random.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

std::vector<Direction> directions_of(Request const& request) {
  if (request.direction == "up") return {Direction::up};
  if (request.direction == "down") return {Direction::down};
  return {Direction::up, Direction::down};
}

std::string own_x(Request const& request) { return or_else(request.x, "disks.packing_fraction"); }

/// Where x covers decades, jumps are steep in ln x, and lie anywhere between two ln x.
bool is_log(Request const& request) { return covers_decades(own_x(request)); }

/// value = {place, factor} for each direction; NaN where there is no jump. Where points are
/// resampled the place is drawn from where it may lie between two of them: resampling alone does
/// not move it.
FitResult jumps_of(Points const& measured, Request const& request, Draw const& draw) {
  bool const log_x = is_log(request);
  auto const points = with_logarithms(measured, log_x, false);
  FitResult out;
  out.points = points.size();
  for (auto const direction : directions_of(request)) {
    auto found = find_jump(points, direction, request.least_factor);
    if (found && draw.replica != 0)
      found->x += std::sqrt(12.0) * found->error *
                  random_offset(draw, direction == Direction::up ? "up" : "down");
    double const place = !found ? unknown : log_x ? std::exp(found->x) : found->x;
    out.value.insert(out.value.end(), {place, found ? found->after / found->before : unknown});
    out.error.insert(out.error.end(),
                     {found ? found->error * (log_x ? place : 1.0) : unknown, unknown});
  }
  return out;
}

/// Says of a curve why it has no jump.
void note_none(Report& report, Series const& series, Request const& request) {
  auto const points = with_logarithms(series.points(0), is_log(request), false);
  for (auto const direction : directions_of(request))
    if (auto const why = why_no_jump(points, direction, request.least_factor); !why.empty())
      report.notes.push_back(fmt::format("{}{}no jump {}: {}", caption(series.labels),
                                         series.labels.empty() ? "" : ": ",
                                         direction == Direction::up ? "up" : "down", why));
}

}  // namespace

void check_direction(Request const& request) {
  for (auto const* known : {"up", "down", "both"})
    if (request.direction == known) return;
  throw InputError(fmt::format("--direction {} (must be up, down or both)", request.direction));
}

std::vector<Outcome> find_jumps(SweepTable const& table, Request const& request,
                                std::vector<Series>& series) {
  check_direction(request);
  series = make_series(table, request, own_x(request), or_else(request.y, "R_v"));
  std::vector<Task> tasks;
  for (std::uint32_t curve = 0; curve < series.size(); ++curve)
    tasks.push_back(
        {series[curve].labels, [=, points = series[curve].points](std::uint32_t replica) {
           return jumps_of(points(replica), request, {request.seed, replica, curve});
         }});
  return carry_out(tasks, request);
}

Report jump(SweepTable const& table, Request const& request) {
  Report report;
  std::vector<Series> series;
  auto const outcomes = find_jumps(table, request, series);
  std::vector<std::string> names;
  for (auto const direction : directions_of(request)) {
    auto const ending = direction == Direction::up ? "_up" : "_down";
    names.insert(names.end(), {symbol(own_x(request)) + ending, std::string("factor") + ending});
  }
  report.results = tabulate(outcomes, names);
  note_left_out(report, table, series);
  for (std::size_t k = 0; k < series.size(); ++k)
    if (outcomes[k].failure.empty()) note_none(report, series[k], request);
  bool const log_x = is_log(request);
  Panel panel(report, own_x(request), or_else(request.y, "R_v"), log_x, true);
  for (std::size_t k = 0; k < series.size(); ++k) {
    auto const curve = caption(series[k].labels);
    panel.data(curve, series[k].points(0), series[k].x_error);
    for (std::size_t place = 0; place < outcomes[k].found.value.size(); place += 2)
      panel.point("mark", curve, outcomes[k].found.value[place], outcomes[k].found.error[place],
                  unknown, unknown);
  }
  std::vector<DrawnParameter> places;
  for (std::size_t k = 0; k < names.size(); k += 2) places.push_back({k, names[k]});
  draw_against_label(report, outcomes, places, symbol(own_x(request)), log_x);
  return report;
}

}  // namespace bagnold::analysis
