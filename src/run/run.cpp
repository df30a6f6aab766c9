// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/config/time_step.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/make_longer.hpp"
#include "src/run/pictures.hpp"
#include "src/run/protocols/cascade/cascade.hpp"
#include "src/run/same_scene.hpp"
#include "src/run/start_or_resume.hpp"
#include "src/run/validate_scene.hpp"

namespace bagnold {

namespace {

RunMonitor& monitor_of(RunOptions const& options) {
  static RunMonitor nobody;
  return options.monitor != nullptr ? *options.monitor : nobody;
}

namespace fs = std::filesystem;

void refuse_sweep(std::filesystem::path const& folder) {
  if (std::filesystem::exists(folder / "points.json"))
    throw InputError(
        fmt::format("{}: holds a sweep; the command that began it goes on with it, also with more "
                    "points or strain in its file: `bagnold sweep FILE --out {}`",
                    folder.string(), shell_word(folder.string())));
}

/// Refuses to change the last state of a point of a sweep from which another point starts.
void refuse_start_of_another(fs::path const& name) {
  auto const folder = fs::weakly_canonical(name);
  if (!fs::exists(folder.parent_path().parent_path() / "points.json")) return;
  for (auto const& other : fs::directory_iterator(folder.parent_path())) {
    auto const scene = other.path() / "scene.toml";
    if (!fs::exists(scene)) continue;
    auto const& start = read_kept_scene(scene).start;
    if (start.kind == "state" && fs::weakly_canonical(start.file) == folder / "state.h5")
      throw InputError(fmt::format(
          "{}: is a point of a sweep from whose last state {} starts, so it cannot be made longer; "
          "run its scene.toml with more shear.strain into a folder of its own",
          name.string(), other.path().filename().string()));
  }
}

/// Refuses to replace a folder that holds the state to start from.
void refuse_own_start(fs::path const& name, Scene const& scene) {
  if (scene.start.kind != "state") return;
  auto const folder = fs::weakly_canonical(name);
  auto const file = fs::weakly_canonical(scene.start.file);
  if (std::ranges::mismatch(folder, file).in1 == folder.end())
    throw InputError(fmt::format(
        "--force: start.file = {} lies in the folder that is replaced; copy it elsewhere first",
        scene.start.file));
}

/// Refuses to change a rate of a cascade by itself.
void refuse_rate_of_cascade(fs::path const& folder, double strain) {
  if (auto const stage = stage_folder_in_cascade(folder))
    throw InputError(fmt::format(
        "{}: is a rate of the cascade in {}, whose last rate alone can be made longer: `bagnold "
        "resume {} --strain {}`",
        folder.string(), stage->cascade.string(), shell_word(stage->cascade.string()), strain));
}

/// Gives a run more strain for `bagnold resume DIR --strain`; in a cascade its last rate, from
/// which no other starts.
void give_strain(RunFolder const& folder, double strain, RunMonitor& monitor) {
  if (!std::filesystem::exists(folder.scene()))
    throw InputError(fmt::format("{}: has no scene.toml; `bagnold resume {}` writes it again",
                                 folder.path().string(), shell_word(folder.path().string())));
  refuse_rate_of_cascade(folder.path(), strain);
  refuse_start_of_another(folder.path());
  Scene const before = read_kept_scene(folder.scene());
  Scene const after = with_strain(before, strain, folder.path().string());
  if (write_scene(after) == write_scene(before)) return;
  if (!before.shear.run_per_rate()) return make_longer(folder, after);
  auto const& rates = after.shear.strain_rates;
  monitor.status(
      fmt::format("the last rate of the cascade, {}, gets {} instead of {} of strain; those before "
                  "stay as they "
                  "are, for each starts from the last state of the one before",
                  rates.back(), strain, before.shear.strain.at(rates.size() - 1)));
  make_cascade_longer(folder, after);
}

/// Makes a finished run as long as its scene.toml says, where a user wrote more strain there.
void take_strain_of_scene(RunFolder const& folder) {
  if (!io::run_finished(folder.path()) || !fs::exists(folder.scene())) return;
  if (auto const cascade = cascade_in(folder)) {
    if (asks_for_more(folder, *cascade)) make_cascade_longer(folder, *cascade);
    return;
  }
  auto const checkpoint = io::newest_checkpoint(folder.path(), nullptr);
  if (!checkpoint) return;
  auto const before = parse_scene(checkpoint->scene, "scene in the checkpoint", folder.path());
  auto const after = read_kept_scene(folder.scene());
  if (!is_longer(before, after)) return;
  refuse_rate_of_cascade(folder.path(), after.shear.strain.at(0));
  refuse_start_of_another(folder.path());
  make_longer(folder, after);
}

/// Continues a run. `finished`: message for a run that is done.
RunEnd go_on(RunFolder const& folder, RunOptions const& options, char const* finished) {
  RunMonitor& monitor = monitor_of(options);
  take_strain_of_scene(folder);
  if (io::run_finished(folder.path())) {
    if (auto const cascade = cascade_in(folder))
      draw_missing_pictures_of_cascade(folder, *cascade);
    else if (std::filesystem::exists(folder.scene()))
      draw_missing_pictures(folder, read_kept_scene(folder.scene()));
    monitor.status(fmt::format("{} is finished: {}", folder.path().string(), finished));
    return RunEnd::done;
  }
  if (auto const scene = cascade_in(folder))
    return run_cascade(folder, *scene, choose(options.machine, *scene), monitor);
  return go_on_in(folder, options.machine, monitor);
}

}  // namespace

RunEnd run(Scene scene, std::filesystem::path const& name, RunOptions const& options) {
  refuse_sweep(name);
  parse_scene(write_scene(scene), "scene", {});  // one made in a program was never checked
  validated_plan(scene, options.allow_unstable);
  scene = resolved(std::move(scene));
  Machine const machine = choose(options.machine, scene);
  if (!options.replace && holds_run(name)) {
    refuse_other_scene(name, scene);  // without a trace
    RunFolder const folder = RunFolder::open(name);
    refuse_other_scene(name, scene);  // another process may have been quicker
    return go_on(folder, options, "the run of this scene is there, --force runs it again");
  }
  if (options.replace && holds_run(name)) refuse_own_start(name, scene);
  auto from_file = states_in_file(runs_of(scene).front());  // read before anything is written
  RunFolder const folder = RunFolder::make(name, options.replace);
  io::replace_text(folder.scene(), write_scene(scene));
  if (scene.shear.run_per_rate()) return run_cascade(folder, scene, machine, monitor_of(options));
  return run_from_start(folder, scene, machine, monitor_of(options), std::move(from_file));
}

RunEnd resume(std::filesystem::path const& name, RunOptions const& options) {
  refuse_sweep(name);
  RunFolder const folder = RunFolder::open(name);
  if (options.strain) give_strain(folder, *options.strain, monitor_of(options));
  return go_on(folder, options, "nothing to resume");
}

}  // namespace bagnold
