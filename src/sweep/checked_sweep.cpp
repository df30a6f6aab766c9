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
  auto const worth_a_word = [](auto const& point) { return !plan_warning(point.plan).empty(); };
  auto const first = std::ranges::find_if(sweep.points, worth_a_word);
  if (first != sweep.points.end())
    warn(fmt::format("{} of {} points, the first is {}: {}",
                     std::ranges::count_if(sweep.points, worth_a_word), sweep.points.size(),
                     first->name, plan_warning(first->plan)));
  return sweep;
}

}  // namespace bagnold::sweep
