// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/plan.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/run_lock.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/last_words.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Standing = RunStatus::State;

double age_of(fs::path const& file) {
  std::error_code error;
  auto const written = fs::last_write_time(file, error);
  if (error) return 0;
  return std::max(
      0.0, std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count());
}

std::vector<std::string> names_in(Json const& summary, char const* list) {
  std::vector<std::string> names;
  for (auto const& one : summary.value(list, Json::array())) names.push_back(one.value("name", ""));
  return names;
}

/// Age of the newest checkpoint, [s]. Between the two renames of its writer only the previous one
/// has its name.
double checkpoint_age(fs::path const& folder) {
  auto const age = age_of(folder / "checkpoint.h5");
  return age > 0 ? age : age_of(folder / "checkpoint.previous.h5");
}

/// Adds what a finished run wrote into its summary.
void add_summary(RunStatus& status, fs::path const& file) try {
  auto const bytes = io::read_file(file);
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  Json const summary = Json::parse(text, text + bytes.size());
  status.warnings = names_in(summary, "warnings");
  status.notes = names_in(summary, "notes");
  if (!summary.contains("strain")) return;  // of a cascade: each rate has its own
  status.strain = status.whole = summary.at("strain").at("total").get<double>();
  status.seconds = summary.at("wall_seconds").get<double>();
  auto const& disks = summary.at("scene").at("disks");
  status.work = status.whole_work = summary.at("steps").get<double>() *
                                    disks.at("count").get<double>() *
                                    disks.at("replicas").get<double>();
} catch (Json::exception const& error) {
  throw FileError(fmt::format("{}: is damaged ({}); remove it and `bagnold resume {}`",
                              file.string(), error.what(),
                              shell_word(file.parent_path().string())));
}

/// Adds the progress of a run that is not done. Returns false if there is no checkpoint.
bool add_checkpoint(RunStatus& status, fs::path const& folder, Plan const& plan, double disks) {
  auto const checkpoint = io::newest_checkpoint(folder, nullptr);
  if (!checkpoint) return false;
  for (auto const& system : checkpoint->systems)
    status.strain += plan.progress(std::min(system.step, plan.steps)) /
                     static_cast<double>(checkpoint->systems.size());
  status.work = static_cast<double>(checkpoint->steps()) * disks;
  status.seconds = checkpoint->wall_seconds;
  status.age = checkpoint_age(folder);
  return true;
}

/// Time that a running process has worked since its last checkpoint, or since it took the folder,
/// [s].
double seconds_of_work(RunStatus const& status, fs::path const& folder) {
  return std::min(status.age, age_of(folder / ".lock"));
}

/// State of a run that is not done and has no process.
Standing without_process(fs::path const& folder, bool begun, RunStatus& status) {
  auto const failed = folder / "failed_state.h5";
  if (fs::exists(failed) && (!begun || age_of(failed) <= checkpoint_age(folder)))
    status.why = fmt::format("numerical failure, its state is in {}", failed.string());
  auto words = last_words(folder / "log.txt");
  if (words.starts_with("note: ") || words.starts_with("warning: ")) words.clear();  // no end
  if (words.starts_with("stopped")) return Standing::stopped;
  if (words.empty() && status.why.empty()) return begun ? Standing::stopped : Standing::not_begun;
  if (!words.empty()) status.why = words;
  return Standing::failed;
}

}  // namespace

std::optional<double> RunStatus::seconds_left() const {
  if (state == Standing::done) return 0.0;
  if (!(seconds > 0) || !(work > 0)) return std::nullopt;
  double const left = (whole_work - work) * seconds / work;
  return std::max(0.0, left - since);
}

RunStatus status_of(fs::path const& folder) {
  if (!fs::exists(folder / "scene.toml") && !fs::exists(folder / "summary.json"))
    throw InputError(fmt::format(
        "{}: holds no run and no sweep; give the --out of `bagnold run` or `bagnold sweep`",
        folder.string()));
  RunStatus status;
  status.holder = io::lock_holder(folder);
  if (io::run_finished(folder)) {
    status.state = Standing::done;
    add_summary(status, folder / "summary.json");
    return status;
  }
  Scene const scene = read_kept_scene(folder / "scene.toml");
  bool begun = false;
  if (!scene.shear.run_per_rate()) {
    Plan const plan = make_plan(scene);
    status.name = plan.progress_name();
    status.whole = plan.progress(plan.steps);
    status.whole_work = disk_steps(scene, plan);
    begun = add_checkpoint(status, folder, plan, static_cast<double>(scene.disks.count));
  }
  status.state =
      !status.holder.empty() ? Standing::running : without_process(folder, begun, status);
  if (status.state == Standing::running) status.since = seconds_of_work(status, folder);
  return status;
}

std::vector<RunStatus> status_of_stages(fs::path const& folder) {
  std::vector<RunStatus> stages;
  if (!fs::exists(folder / "scene.toml")) return stages;
  Scene const scene = read_kept_scene(folder / "scene.toml");
  if (!scene.shear.run_per_rate()) return stages;
  for (std::size_t k = 0; k < scene.shear.strain_rates.size(); ++k) {
    auto const path = folder / stage_folder(scene, k);
    if (fs::exists(path / "scene.toml")) {
      stages.push_back(status_of(path));
      continue;
    }
    stages.push_back(status_not_begun(stage_of(scene, k, "")));
  }
  return stages;
}

RunStatus status_not_begun(Scene const& scene) {
  RunStatus status;
  auto const plan = make_plan(scene);
  status.name = plan.progress_name();
  status.whole = plan.progress(plan.steps);
  status.whole_work = disk_steps(scene, plan);
  return status;
}

char const* word(RunStatus::State state) {
  switch (state) {
    case Standing::not_begun:
      return "not begun";
    case Standing::running:
      return "running";
    case Standing::stopped:
      return "stopped";
    case Standing::failed:
      return "failed";
    case Standing::done:
      break;
  }
  return "done";
}

}  // namespace bagnold
