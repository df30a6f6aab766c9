// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/start_or_resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "src/config/errors.hpp"
#include "src/config/ladder.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/config/toml_text.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/state_file.hpp"
#include "src/run/bias/methods.hpp"
#include "src/run/make_longer.hpp"
#include "src/run/messages.hpp"
#include "src/run/protocols/cascade/cascade.hpp"
#include "src/run/runner.hpp"
#include "src/run/warnings/checks.hpp"
#include "src/start/deep_overlaps.hpp"
#include "src/start/relax_overlaps.hpp"

namespace bagnold {

namespace {

Replica replica_of(io::SystemCheckpoint& checkpoint) {
  Replica replica;
  replica.start_record = std::move(checkpoint.start_record);
  replica.saved_frames = std::move(checkpoint.frames);
  if (auto control = checkpoint.arrays.extract(controller_name); !control.empty())
    replica.saved_control = std::move(control.mapped());
  if (auto pairs = checkpoint.arrays.extract(bias::pairs_name); !pairs.empty())
    replica.saved_pairs = std::move(pairs.mapped());
  auto& [windows, open, frames, controller] = replica.measurement;
  windows = {static_cast<std::size_t>(checkpoint.columns), std::move(checkpoint.window_sums),
             std::move(checkpoint.window_weight)};
  open.first = static_cast<std::int64_t>(windows.size());
  open.sums = {{std::move(checkpoint.open_sums), checkpoint.open_weight}};
  return replica;
}

Run run_of(Scene const& scene, Plan const& plan, Machine const& machine) {
  Run run;
  run.scene = scene;
  run.plan = plan;
  run.backend = machine.backend;
  return run;
}

/// Windows of scheme = "auto" have another length in another version, at some rates.
void refuse_other_windows(io::SystemCheckpoint const& system, Scene const& scene,
                          Plan const& plan) {
  if (!may_change_method(scene)) return;
  auto const finished = std::min(system.step / plan.window_steps, plan.windows);
  if (static_cast<std::int64_t>(system.window_weight.size()) != finished)
    throw InputError(fmt::format(
        "the checkpoint has {} windows at step {}, where scheme = \"auto\" has {} in this version; "
        "resume with the version that wrote it, or begin from its state with start.kind = "
        "\"state\"",
        system.window_weight.size(), system.step, finished));
}

/// `longer`: set if the run was made longer since.
RunEnd run_from_checkpoint(RunFolder const& folder, io::Checkpoint checkpoint, Scene const& scene,
                           std::optional<Longer> const& longer, Machine machine,
                           RunMonitor& monitor) {
  if (checkpoint.systems.size() != static_cast<std::size_t>(scene.disks.replicas))
    throw InputError(
        fmt::format("{}: the checkpoint holds {} systems, its scene says disks.replicas "
                    "= {} (must agree); start the run again",
                    folder.path().string(), checkpoint.systems.size(), scene.disks.replicas));
  machine = choose(machine, scene);
  KokkosScope const kokkos(machine, scene);
  Plan const plan = make_plan(scene);
  Run run = run_of(scene, plan, machine);
  run.wall_seconds = checkpoint.wall_seconds;
  if (longer)
    for (auto const& line : longer->remarks(checkpoint)) monitor.status(line);
  monitor.status(fmt::format("going on from step {} of {}", checkpoint.steps(),
                             plan.steps * scene.disks.replicas));
  if (auto const now = level_of(scene.disks.model, scene.drive.kind).name;
      !checkpoint.simd.empty() && checkpoint.simd != now)
    monitor.status(fmt::format(
        "this run was begun with the instructions {} and goes on with {}: its bits will be others "
        "than without the break, by rounding; where they must not, use BAGNOLD_SIMD={}",
        checkpoint.simd, now, checkpoint.simd));
  std::vector<std::optional<Snapshot>> snapshots;
  for (auto& system : checkpoint.systems) {
    if (longer) longer->reopen_last_window(system);
    refuse_other_windows(system, scene, plan);
    run.replicas.push_back(replica_of(system));
    run.replicas.back().discards_more = longer && longer->discards_more();
    snapshots.push_back(std::move(static_cast<Snapshot&>(system)));
  }
  Runner runner(folder, std::move(run), machine, monitor);
  if (!runner.start(std::move(snapshots))) return RunEnd::stopped;
  return runner.run();
}

/// Message on the state with the largest share of mean motion; "" if none had any.
std::string mean_motion_taken_off(std::vector<StartedState> const& started) {
  MeanMotion most{};
  for (auto const& one : started)
    if (one.mean_motion && one.mean_motion->share > most.share) most = *one.mean_motion;
  return most.share > 0 ? mean_motion_in_words(most.velocity, most.share) + " is taken off" : "";
}

/// Scene beside a checkpoint, if it is that of the checkpoint with more strain. InputError if it is
/// neither that nor the checkpoint's.
std::optional<Longer> longer_than(Scene const& before, RunFolder const& folder) {
  Scene const after = read_kept_scene(folder.scene());
  if (write_scene(after) == write_scene(before)) return std::nullopt;
  if (is_longer(before, after)) return Longer(before, after);
  throw InputError(
      fmt::format("{} is not the scene of the checkpoint beside it; put it back (of it only "
                  "shear.strain may grow: `bagnold resume {} --strain ...`), or start a new run "
                  "with it in another folder",
                  folder.scene().string(), shell_word(folder.path().string())));
}

}  // namespace

std::vector<StartedState> states_in_file(Scene const& scene) {
  if (scene.start.kind != "state") return {};
  auto started = fit_to_scene(io::read_states(scene.start.file), scene);
  if (!scene.start.relax)
    for (auto const& one : started)
      warn(deep_overlap_warning(one.state,
                                scene.start.file + (scene.start.copies ? ", its copies" : "")));
  return started;
}

RunEnd run_from_start(RunFolder const& folder, Scene const& scene, Machine const& machine,
                      RunMonitor& monitor, std::vector<StartedState> started) {
  KokkosScope const kokkos(machine, scene);
  Plan const plan = make_plan(scene);
  auto const replicas = static_cast<std::size_t>(scene.disks.replicas);
  Run run = run_of(scene, plan, machine);
  run.replicas.resize(replicas);
  monitor.status(bias::method_in_words(scene));
  std::vector<std::optional<Snapshot>> snapshots(replicas);
  if (auto const what = mean_motion_taken_off(started); !what.empty())
    monitor.status(fmt::format("{}: {}", scene.start.file, what));
  if (scene.start.relax)
    monitor.status(fmt::format("relaxing the overlaps of {}", scene.start.file));
  for (std::size_t r = 0; r < started.size(); ++r) {
    try {
      if (scene.start.relax)
        relax_state(started[r], scene, [&] { return !monitor.stop_requested(); });
    } catch (StartStopped const&) {
      say(stopped_before_the_first_step(scene, folder_to_resume(folder.path())));
      return RunEnd::stopped;
    }
    run.replicas[r].start_record = std::move(started[r].record);
    snapshots[r] = first_snapshot(std::move(started[r].state));
  }
  if (started.empty())
    monitor.status(fmt::format("relaxing the overlaps of {} random disks{}", scene.disks.count,
                               replicas > 1 ? fmt::format(", {} times", replicas) : ""));
  Runner runner(folder, std::move(run), machine, monitor);
  if (!runner.start(std::move(snapshots))) return RunEnd::stopped;
  return runner.run();
}

RunEnd go_on_in(RunFolder const& folder, Machine const& machine, RunMonitor& monitor) {
  std::vector<std::string> remarks;
  auto checkpoint = io::newest_checkpoint(folder.path(), &remarks);
  for (auto const& remark : remarks) say(remark);
  if (checkpoint && !std::filesystem::exists(folder.scene()))
    io::replace_text(folder.scene(), checkpoint->scene);
  if (checkpoint) {
    Scene scene = parse_scene(checkpoint->scene, "scene in the checkpoint", folder.path());
    auto const longer = longer_than(scene, folder);
    if (longer) {
      longer->refuse_mixed_frames(*checkpoint);
      drop_results(folder);
      scene = longer->after;
      io::replace_text(folder.scene(), write_scene(scene));
    }
    return run_from_checkpoint(folder, std::move(*checkpoint), scene, longer, machine, monitor);
  }

  if (begun(folder.path()))
    say(fmt::format("no checkpoint in {} can be used: starting again from its scene.toml",
                    folder.path().string()));
  Scene const scene = read_kept_scene(folder.scene());
  return run_from_start(folder, scene, choose(machine, scene), monitor, states_in_file(scene));
}

}  // namespace bagnold
