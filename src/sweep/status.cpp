// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/run_lock.hpp"

namespace bagnold::sweep {

namespace fs = std::filesystem;

std::size_t SweepStatus::count(RunStatus::State state) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(points, [&](Point const& point) { return point.run.state == state; }));
}

double SweepStatus::share() const {
  double done = 0, all = 0;
  for (auto const& [folder, run] : points) {
    done += run.work;
    all += run.whole_work;
  }
  return all > 0 ? done / all : 0;
}

std::optional<double> SweepStatus::core_seconds_left() const {
  double seconds = 0, work = 0, left = 0;
  for (auto const& [folder, run] : points) {
    seconds += run.seconds;
    work += run.work;
  }
  if (!(work > 0) || !(seconds > 0)) return std::nullopt;
  for (auto const& [folder, run] : points) {
    if (run.state == RunStatus::State::failed) continue;
    left += run.seconds_left().value_or((run.whole_work - run.work) * seconds / work);
  }
  return left;
}

std::optional<SweepStatus> status_of_sweep(fs::path const& folder) {
  auto const file = folder / "points.json";
  if (!fs::exists(file)) return std::nullopt;
  auto const bytes = io::read_file(file);
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  auto const all = nlohmann::json::parse(text, text + bytes.size(), nullptr,
                                         /*allow_exceptions=*/false);
  if (!all.is_object() || !all.contains("points") || !all["points"].is_array())
    throw InputError(fmt::format("{}: is damaged; the command that began the sweep writes it again",
                                 file.string()));
  SweepStatus status;
  status.holder = io::lock_holder(folder);
  status.for_slurm = fs::exists(folder / "points.slurm");
  status.left = all.value("left", nlohmann::json::array()).size();
  for (auto const& point : all["points"]) {
    auto const name = point.value("folder", "");
    auto const path = folder / "points" / name;
    status.points.push_back(
        {name, fs::exists(path / "scene.toml")
                   ? status_of(path)
                   : status_not_begun(parse_scene(point.value("scene", ""), name, path))});
  }
  return status;
}

}  // namespace bagnold::sweep
