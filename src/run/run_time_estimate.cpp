// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_time_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "src/config/errors.hpp"
#include "src/config/strain_rates.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/io/state_file.hpp"
#include "src/run/machine.hpp"
#include "src/run/run_time_trial.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

constexpr double most_budget = 1.2;  ///< of a scene's trial, CPU time, [s]
constexpr double point_budget = 0.3;
constexpr std::size_t most_trials = 8;

/// Time of a trial: short runs, by the number of steps, get short trials.
double budget_of(double most, double steps_say) { return std::clamp(steps_say / 10, 0.03, most); }

/// Reason why no trial is possible here; "" if it is.
std::string why_no_trial() {
  auto const names = backend_names();
  if (std::ranges::find(names, "serial") == names.end()) return "no serial backend in this build";
  return why_no_start();
}

RunTimes by_steps(std::vector<Scene> const& runs, std::string const& reason) {
  RunTimes times;
  for (auto const& run : runs) times.each.push_back(time_by_steps(run, make_plan(run)));
  times.how = fmt::format("by the number of steps alone, for no trial could be made ({})", reason);
  return times;
}

Machine const one_core{"serial", 1};

/// Coordinates that determine the time of a disk for a unit of strain, so that nearby points take
/// similar times: logarithms of numbers, and words that must be equal.
struct Place {
  std::array<double, 4> number;
  std::array<std::string, 5> word;

  explicit Place(Scene const& scene)
      : number{std::log10(std::max(typical_rate(scene), 1e-9)), std::log10(scene.disks.elasticity),
               10 * scene.disks.packing_fraction,
               0.3 * std::log10(static_cast<double>(scene.disks.count))},
        word{scene.disks.model, scene.shear.protocol, scene.integration.engine,
             scene.integration.scheme,
             fmt::format("{} {} {} {}", scene.measure.contacts, scene.measure.correlations,
                         scene.measure.clusters, scene.measure.profiles || scene.measure.fields)} {}

  double distance(Place const& other) const {
    double sum = 0;
    for (std::size_t k = 0; k < number.size(); ++k) sum += std::abs(number[k] - other.number[k]);
    for (std::size_t k = 0; k < word.size(); ++k) sum += word[k] == other.word[k] ? 0 : 3;
    return sum;
  }
};

/// Runs that are far from each other, the one of most steps first; at most `most`.
std::vector<std::size_t> far_apart(std::vector<PlannedRun> const& runs,
                                   std::vector<Place> const& places) {
  auto const steps = [](PlannedRun const& run) { return disk_steps(run.scene, run.plan); };
  auto const most = std::ranges::max_element(runs, {}, steps);
  std::vector<std::size_t> chosen{static_cast<std::size_t>(most - runs.begin())};
  std::vector<double> nearest(places.size(), std::numeric_limits<double>::max());
  while (chosen.size() < most_trials) {
    for (std::size_t k = 0; k < places.size(); ++k)
      nearest[k] = std::min(nearest[k], places[k].distance(places[chosen.back()]));
    auto const next = std::ranges::max_element(nearest);
    if (*next == 0) break;
    chosen.push_back(static_cast<std::size_t>(next - nearest.begin()));
  }
  return chosen;
}

/// Disks times strain, of all replicas; of a stop nearly none.
double disk_strain(PlannedRun const& run) {
  return std::max(run.plan.path(run.plan.steps), 1e-12) *
         static_cast<double>(run.scene.disks.count * run.scene.disks.replicas);
}

std::optional<State> given_state(Scene const& scene) {
  if (scene.start.kind != "state" || !std::filesystem::path(scene.start.file).is_absolute())
    return std::nullopt;
  return fit_to_scene(io::read_states(scene.start.file), scene).front().state;
}

/// Times of the runs tried, beside pictures, over disks and strain.
struct Tried {
  Place place;
  double log_cost;
};

/// Interpolates between the runs tried; nearer ones have more weight.
double cost_at(Place const& place, std::vector<Tried> const& tried) {
  double sum = 0, weights = 0;
  for (auto const& one : tried) {
    double const distance = place.distance(one.place);
    if (distance == 0) return std::exp(one.log_cost);
    double const weight = std::pow(distance, -4);
    sum += weight * one.log_cost;
    weights += weight;
  }
  return std::exp(sum / weights);
}

}  // namespace

RunTime RunTimes::sum() const {
  RunTime all;
  for (auto const& one : each) all += one;
  return all;
}

RunTimes times_of_runs(std::vector<Scene> const& runs, std::optional<State> start) {
  if (auto const why = why_no_trial(); !why.empty()) return by_steps(runs, why);
  KokkosScope const kokkos(one_core, runs.front());
  double by_count = 0;
  for (auto const& run : runs) by_count += time_by_steps(run, make_plan(run)).expected;
  double const budget = budget_of(most_budget, by_count);
  try {
    RunTimeTrial trial(runs.front(), std::move(start), budget / 2);
    RunTimes times;
    for (auto const& run : runs)
      times.each.push_back(
          trial.time_of(run, make_plan(run), budget / 2 / static_cast<double>(runs.size())));
    times.how = fmt::format("from {:.1g} s of {} such disks", budget, trial.disks());
    return times;
  } catch (NumericalError const& error) {
    return by_steps(runs, error.what());
  }
}

RunTimes times_of_many(std::vector<PlannedRun> const& runs) {
  std::vector<Scene> scenes;
  std::vector<Place> places;
  for (auto const& run : runs) {
    scenes.push_back(run.scene);
    places.emplace_back(run.scene);
  }
  if (auto const why = why_no_trial(); !why.empty()) return by_steps(scenes, why);
  KokkosScope const kokkos(one_core, scenes.front());
  std::vector<Tried> tried;
  try {
    for (auto const k : far_apart(runs, places)) {
      auto const& [scene, plan] = runs[k];
      double const budget = budget_of(point_budget, time_by_steps(scene, plan).expected);
      RunTimeTrial trial(scene, given_state(scene), budget / 2);
      double const seconds = trial.time_of(scene, plan, budget / 2).expected - pictures_take(scene);
      tried.push_back({places[k], std::log(seconds / disk_strain(runs[k]))});
    }
  } catch (NumericalError const& error) {
    return by_steps(scenes, error.what());
  }
  RunTimes times;
  for (std::size_t k = 0; k < scenes.size(); ++k)
    times.each.push_back(
        run_time(pictures_take(scenes[k]) + disk_strain(runs[k]) * cost_at(places[k], tried)));
  times.how = fmt::format("from trials of {} of them", tried.size());
  return times;
}

}  // namespace bagnold
