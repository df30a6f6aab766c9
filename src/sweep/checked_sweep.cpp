// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/checked_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/io/state_file.hpp"
#include "src/run/messages.hpp"
#include "src/run/validate_scene.hpp"
#include "src/start/start.hpp"

namespace bagnold::sweep {

PointCheck point_check(bool allow_unstable) {
  return [allow_unstable](Scene const& scene, Plan const& plan) {
    validate_scene(scene, plan, allow_unstable);
    bool const later =
        !scene.start.file.empty() && !std::filesystem::path(scene.start.file).is_absolute();
    if (scene.start.kind == "state" && !later)
      fit_to_scene(io::read_states(scene.start.file), scene);
  };
}

Sweep read_checked_sweep(std::filesystem::path const& file, bool allow_unstable) {
  auto sweep = read_sweep(file, point_check(allow_unstable));
  auto const worth_a_word = [](auto const& point) {
    return !plan_warning(point.scene, point.plan).empty();
  };
  auto const first = std::ranges::find_if(sweep.points, worth_a_word);
  if (first != sweep.points.end())
    warn(fmt::format("{} of {} points, the first is {}: {}",
                     std::ranges::count_if(sweep.points, worth_a_word), sweep.points.size(),
                     first->name, plan_warning(first->scene, first->plan)));
  return sweep;
}

std::string rising_chain_note(Sweep const& sweep) {
  for (auto const& point : sweep.points) {
    if (!point.previous) continue;
    auto const& before = sweep.points[*point.previous].scene.shear;
    if (before.strain_rate >= point.scene.shear.strain_rate) continue;
    return fmt::format(
        "sweep.chain rises in shear.strain_rate, from {} to {} at {}: it begins at its slowest "
        "rate, where a random start takes the most steps to be forgotten, and where the flow has a "
        "hysteresis it follows the branch of slow flow; P2 goes down: give the largest rate first, "
        "unless the way up is meant",
        before.strain_rate, point.scene.shear.strain_rate, point.name);
  }
  return {};
}

}  // namespace bagnold::sweep
