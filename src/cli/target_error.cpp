// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/target_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/statistics/steady_start.hpp"

namespace bagnold {

namespace {

constexpr std::int64_t first_look = 100;  // windows: fewer seldom have 8 blocks

}  // namespace

std::int64_t next_look(std::int64_t windows, std::int64_t most) {
  std::int64_t look = first_look;
  while (look < windows) look += (look + 9) / 10;
  return std::min(look, most);
}

std::map<std::string, std::optional<double>> reached_errors(Run const& run) {
  std::map<std::string, std::optional<double>> reached;
  auto const& wanted = run.scene.shear.target_error;
  if (wanted.empty()) return reached;
  for (auto const& observable : observables(run.scene, run.box_length)) {
    std::string const name(observable.name);
    if (!wanted.contains(name)) continue;
    auto const all = estimate(run, observable.value).all;
    reached[name] = all.mean && all.error ? std::optional(*all.error / std::abs(*all.mean))
                                          : std::nullopt;
  }
  return reached;
}

bool all_reached(Run const& run) {
  return !run.reached.empty() && std::ranges::all_of(run.reached, [&](auto const& one) {
    auto const& [name, error] = one;
    return error && *error <= run.scene.shear.target_error.at(name);
  });
}

void discard_transient(Run& run) {
  if (run.scene.shear.discard || run.plan.ramp) return;
  statistics::SteadyStart latest{0, true};
  for (auto const& observable : observables(run.scene, run.box_length)) {
    if (observable.name != "B_p" && observable.name != "B_sigma") continue;
    auto const start = statistics::steady_start(window_series(run, observable));
    latest = {std::max(latest.first, start.first), latest.found && start.found};
  }
  run.plan.discarded_windows = static_cast<std::int64_t>(latest.first);
  run.steady_found = latest.found;
}

void check_target(Scene const& scene) {
  std::vector<std::string> names;
  for (auto const& observable : observables(scene, scene.box_length()))
    names.emplace_back(observable.name);
  for (auto const& [name, error] : scene.shear.target_error)
    if (std::ranges::find(names, name) == names.end())
      throw InputError(
          fmt::format("shear.target_error = {{ {} = {} }} (no such NAME in this scene's "
                      "summary.json); did you mean {}?",
                      name, error, nearest_word(name, names)));
}

}  // namespace bagnold
