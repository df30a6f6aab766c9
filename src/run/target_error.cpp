// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/target_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/measure/make_frames.hpp"
#include "src/run/collisions.hpp"
#include "src/run/warnings/warning.hpp"
#include "src/statistics/steady_start.hpp"
#include "src/statistics/stopping.hpp"

namespace bagnold {

namespace {

bool has_target(Scene const& scene) { return !scene.shear.target_error.empty(); }

/// Relative error; none if nothing was measured: for a mean of 0, or a series that does not vary.
std::optional<double> relative_error(statistics::Estimate const& of) {
  if (!of.mean || !of.error || *of.mean == 0 || *of.error == 0) return {};
  return *of.error / std::abs(*of.mean);
}

/// Measured strain of a run of `windows` windows, the first of which are discarded.
double measured_strain(Plan const& plan, std::int64_t windows, std::size_t discarded) {
  auto const end_of = [&](std::int64_t count) {
    return count == 0 ? 0.0 : plan.path(plan.window_end(count - 1));
  };
  return end_of(windows) - end_of(static_cast<std::int64_t>(discarded));
}

/// Beginning of the steady state in the first `windows` windows, by settling_names, averaged over
/// replicas; the later one counts.
statistics::SteadyStart steady_start(Run const& run, std::size_t windows) {
  statistics::SteadyStart latest{0, true};
  auto const names = settling_names(run);
  for (auto const& observable : observables(run.scene, run.box_length)) {
    if (std::ranges::count(names, observable.name) == 0) continue;
    auto const all = window_series(run, observable);
    auto so_far = std::span(all).first(std::min(windows, all.size()));
    auto const dropped =
        std::min(static_cast<std::size_t>(run.plan.dropped_windows), so_far.size());
    so_far = so_far.subspan(dropped);
    auto start = statistics::steady_start(so_far);
    if (has_target(run.scene)) start.first = std::min(2 * start.first, (so_far.size() + 1) / 2);
    start.first += dropped;
    latest = {std::max(latest.first, start.first), latest.found && start.found};
  }
  return latest;
}

std::size_t discarded_of(Run const& run, std::int64_t windows) {
  if (!run.scene.shear.discard) return steady_start(run, static_cast<std::size_t>(windows)).first;
  return static_cast<std::size_t>(shortened(run.scene, run.plan, windows).discarded_windows);
}

/// Names of all quantities that can be measured on frames.
std::vector<std::string> names_of_frames(Scene scene) {
  scene.measure.profiles = scene.measure.fields = scene.measure.rotation = true;
  State start;
  start.box_length = scene.box_length();
  auto const frames = make_frames(scene, {}, start, {}, {});
  std::vector<std::string> names;
  for (auto const& one : Frames::observables({&frames})) names.emplace_back(one.observable.name);
  return names;
}

/// Largest number of collisions of a disk in a measured strain. mean: of an observable by its name.
template <class Mean>
double collisions_in(Run const& run, double strain, Mean const& mean) {
  auto const list = observables(run.scene, run.box_length);
  auto const of = [&](std::string_view name) {
    return mean(*std::ranges::find(list, name, &Observable::name)).value_or(0);
  };
  double const contacts = of("Z");
  return collisions_per_disk(run.scene, contacts, strain,
                             mean_overlap(run.scene, of("p_el"), contacts, run.box_area()));
}

/// True if the first `windows` windows meet the target of every name and disks have collided often
/// enough in them.
bool met_at(Run const& run, std::int64_t windows) {
  std::vector<statistics::Windows> so_far;
  for (auto const& replica : run.replicas)
    so_far.push_back(replica.measurement.windows.first(static_cast<std::size_t>(windows)));
  std::vector<statistics::Windows const*> addresses;
  for (auto const& replica : so_far) addresses.push_back(&replica);
  auto const discarded = discarded_of(run, windows);
  if (std::cmp_greater_equal(discarded, windows)) return false;
  auto const& wanted = run.scene.shear.target_error;
  auto const estimate = [&](Observable const& of) {
    return statistics::estimate(addresses, discarded, of.value);
  };
  double const collisions =
      collisions_in(run, measured_strain(run.plan, windows, discarded),
                    [&](Observable const& of) { return estimate(of).all.mean; });
  if (!(collisions >= fewest_collisions)) return false;
  for (auto const& observable : observables(run.scene, run.box_length)) {
    auto const target = wanted.find(std::string(observable.name));
    if (target == wanted.end()) continue;
    auto const found = estimate(observable);
    auto const error = relative_error(statistics::cautious(found));
    if (!statistics::long_enough(found) || !error || *error > target->second) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string_view> settling_names(Run const& run) {
  if (run.scene.shear.finds_rate()) return {"p", "strain_rate"};
  if (run.scene.shear.changes_box()) return {"packing_fraction", "B_sigma"};
  return {"B_p", "B_sigma"};
}

void judge_errors(Run& run) {
  discard_transient(run);
  if (!has_target(run.scene)) return;
  for (auto const& observable : observables(run.scene, run.box_length)) {
    std::string const name(observable.name);
    if (run.scene.shear.target_error.contains(name))
      run.reached[name] = relative_error(estimate(run, observable.value).all);
  }
  run.target_met = statistics::met_twice(
      run.plan.windows, [&](std::int64_t windows) { return met_at(run, windows); });
}

std::string until_target(Run const& run) {
  double times = 0;  // of what is short: errors, independent windows, collisions
  double const collisions =
      collisions_in(run,
                    measured_strain(run.plan, run.plan.windows,
                                    static_cast<std::size_t>(run.plan.discarded_windows)),
                    [&](Observable const& of) { return estimate(run, of.value).all.mean; });
  if (collisions < fewest_collisions) times = std::max(times, fewest_collisions / collisions);
  for (auto const& observable : observables(run.scene, run.box_length)) {
    auto const found = estimate(run, observable.value);
    auto const reached = run.reached.find(std::string(observable.name));
    if (reached == run.reached.end()) continue;
    if (!reached->second) return {};
    times = std::max(
        times, std::pow(*reached->second / run.scene.shear.target_error.at(reached->first), 2));
    for (auto const& one : found.each)
      if (one.independent > 0)
        times = std::max(times, statistics::fewest_independent / one.independent);
  }
  return longer_run(run, statistics::look_factor * times);
}

void discard_transient(Run& run) {
  if (run.scene.shear.discard || !run.plan.has_one_rate() || run.plan.stages > 1) return;
  auto const start = steady_start(run, static_cast<std::size_t>(run.plan.windows));
  run.plan.discarded_windows = static_cast<std::int64_t>(start.first);
  run.steady_found = start.found;
}

void check_target(Scene const& scene) {
  if (!has_target(scene)) return;
  std::vector<std::string> names;
  for (auto const& observable : observables(scene, scene.box_length()))
    names.emplace_back(observable.name);
  auto const of_frames = names_of_frames(scene);
  for (auto const& [name, error] : scene.shear.target_error)
    if (std::ranges::find(of_frames, name) != of_frames.end())
      throw InputError(fmt::format(
          "shear.target_error = {{ {} = {} }} (is measured on frames, and where these "
          "begin depends on where the run ends); name what every window has, as B_p, or "
          "give shear.strain alone",
          name, error));
    else if (std::ranges::find(names, name) == names.end())
      throw InputError(
          fmt::format("shear.target_error = {{ {} = {} }} (no such NAME in this scene's "
                      "summary.json){}",
                      name, error, did_you_mean(name, names)));
}

}  // namespace bagnold
