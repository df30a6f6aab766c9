// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_measured.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "src/run/stretch_size.hpp"

namespace bagnold {

namespace {

/// Gives a window of fewer evaluations, those of a method of longer steps, or of more, those of a
/// stretch that is the run's own, the weight of others.
void weigh_as_others(WindowSums& done, Plan const& plan, std::int64_t window) {
  auto const steps = plan.window_end(window) - plan.window_begin(window);
  auto const evaluations = static_cast<double>((steps + plan.every - 1) / plan.every);
  double const factor = evaluations / done.weight;
  for (double& sum : done.sums) sum *= factor;
  done.weight = evaluations;
}

/// Advances one system to `stop`, or to where it can stop, and takes its measurements. Returns
/// false if it goes no further (LegEnd::whole).
bool advance(MeasuredSystem const& system, std::int64_t stop, Plan const& plan, LegEnd end) {
  auto& [simulation, measurement, pairs] = system;
  auto const from = simulation.step();
  auto row = plan.row_of(from);
  stop = std::min(stop, plan.row_end(row));
  if (measurement.controller) {
    row.steps = plan.control_steps;
    stop = std::min(stop, (from / row.steps + 1) * row.steps);
  }
  Sampling const sampling{.window_steps = row.steps,
                          .every = pairs ? pairs->every(plan.every) : plan.every,
                          .last_step = plan.steps,
                          .whole = end == LegEnd::whole,
                          .first_step = row.begin,
                          .first_window = row.first};
  simulation.advance(stop - from, sampling, measurement.open);
  measurement.frames.show(simulation, from);
  if (measurement.controller) {
    if (simulation.step() % row.steps == 0)
      measurement.controller->end_piece(simulation, measurement.open.take_first(),
                                        measurement.windows);
    return true;
  }
  while (measurement.open.first < plan.windows &&
         plan.window_end(measurement.open.first) <= simulation.step()) {
    WindowSums done = measurement.open.take_first();
    if (pairs && pairs->chooses()) weigh_as_others(done, plan, measurement.open.first - 1);
    measurement.windows.push_back(done.sums, done.weight);
  }
  return simulation.step() >= std::min(stop, plan.steps);
}

/// Pairs that are due at the present steps. Returns false if one is not done. At the end of the run
/// none is taken that could change its method.
bool take_pairs(std::span<MeasuredSystem const> systems, Plan const& plan,
                std::function<bool()> const& go_on) {
  for (std::size_t s = 0; s < systems.size(); ++s) try {
      if (auto const& [simulation, measurement, pairs] = systems[s];
          pairs && !(pairs->chooses() && simulation.step() >= plan.steps) &&
          !pairs->take(simulation, measurement.windows, go_on))
        return false;
    } catch (NumericalError const& error) {
      throw SystemFailure(s, error);
    }
  return true;
}

constexpr auto nobody = std::numeric_limits<std::int64_t>::max();

/// Step of the system that is furthest behind, of those that continue.
std::int64_t step_of(std::span<MeasuredSystem const> systems, std::vector<bool> const& ended) {
  auto least = nobody;
  for (std::size_t s = 0; s < systems.size(); ++s)
    if (!ended[s]) least = std::min(least, systems[s].simulation.step());
  return least;
}

}  // namespace

bool run_measured(std::span<MeasuredSystem const> systems, Plan const& plan,
                  std::function<bool()> const& go_on, LegEnd end) {
  StretchSize stretch;
  std::vector<bool> ended(systems.size(), false);
  for (auto const& [simulation, measurement, pairs] : systems)
    if (simulation.step() == 0) measurement.frames.show(simulation, -1);
  for (auto from = step_of(systems, ended); from < plan.steps; from = step_of(systems, ended)) {
    if (!take_pairs(systems, plan, go_on)) return false;
    auto const start = std::chrono::steady_clock::now();
    auto stop = from + stretch.steps();
    for (auto const& [simulation, measurement, pairs] : systems) {
      stop = std::min(stop, measurement.frames.next(simulation.step()));
      if (pairs) stop = std::min(stop, pairs->next(simulation.step()));
    }
    for (std::size_t s = 0; s < systems.size(); ++s) {
      if (ended[s] || systems[s].simulation.step() >= std::min(stop, plan.steps)) continue;
      try {
        ended[s] = !advance(systems[s], stop, plan, end);
      } catch (NumericalError const& error) {
        throw SystemFailure(s, error);
      }
    }
    stretch.took(std::chrono::steady_clock::now() - start);
    if (!go_on()) return false;
  }
  return take_pairs(systems, plan, go_on);  // others may wait for them
}

bool run_measured(Simulation& simulation, Plan const& plan, Measurement& measurement,
                  std::function<bool()> const& go_on, LegEnd end) {
  MeasuredSystem const one{simulation, measurement};
  return run_measured({&one, 1}, plan, go_on, end);
}

}  // namespace bagnold
