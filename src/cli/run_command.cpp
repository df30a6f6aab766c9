// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/cli/commands.hpp"
#include "src/cli/run_folder.hpp"
#include "src/cli/runner.hpp"
#include "src/cli/signals.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/toml_text.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/state_file.hpp"
#include "src/protocols/steady.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// What the scene asks for.
Protocol protocol_of(Plan const& plan) {
  return
      [plan](Simulation& simulation, Measurement& measurement, std::function<bool()> const& go_on) {
        return run_steady(simulation, plan, measurement, go_on);
      };
}

/// The first states of a scene that has them in a file, [R]; none: random starts are yet to be
/// made. The file is read before anything is written.
std::vector<StartedState> states_in_file(Scene const& scene) {
  if (scene.start.kind != "state") return {};
  return fit_to_scene(io::read_states(scene.start.file), scene);
}

Snapshot snapshot_of(io::SystemCheckpoint& checkpoint) {
  Snapshot snapshot;
  snapshot.state = std::move(checkpoint.state);
  snapshot.list_position = std::move(checkpoint.list_position);
  snapshot.list_step = checkpoint.list_step;
  snapshot.step = checkpoint.step;
  snapshot.initial_offset = checkpoint.initial_offset;
  snapshot.initial_time = checkpoint.initial_time;
  snapshot.list_builds = checkpoint.builds;
  snapshot.engine = std::move(checkpoint.engine);
  return snapshot;
}

Replica replica_of(io::SystemCheckpoint& checkpoint) {
  Replica replica;
  replica.start_record = std::move(checkpoint.start_record);
  replica.saved_frames = std::move(checkpoint.frames);
  auto& [windows, open, frames] = replica.measurement;
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

int run_from_start(RunFolder const& folder, Scene const& scene, Plan const& plan,
                   Machine const& machine, bool quiet, std::vector<StartedState> started) {
  KokkosScope const kokkos(machine, scene);
  auto const replicas = static_cast<std::size_t>(scene.disks.replicas);
  Run run = run_of(scene, plan, machine);
  run.replicas.resize(replicas);
  std::vector<std::optional<Snapshot>> snapshots(replicas);
  for (std::size_t r = 0; r < started.size(); ++r) {
    run.replicas[r].start_record = std::move(started[r].record);
    snapshots[r] = first_snapshot(std::move(started[r].state));
  }
  if (started.empty() && !quiet)
    fmt::print("relaxing the overlaps of {} random disks{}\n", scene.disks.count,
               replicas > 1 ? fmt::format(", {} times", replicas) : "");
  Runner runner(folder, std::move(run), machine, quiet);
  runner.start(std::move(snapshots));
  return runner.run(protocol_of(plan));
}

int run_from_checkpoint(RunFolder const& folder, io::Checkpoint checkpoint, Machine machine,
                        bool quiet) {
  Scene const scene = parse_scene(checkpoint.scene, "scene in the checkpoint", folder.path());
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
  if (!quiet)
    fmt::print("going on from step {} of {}\n", checkpoint.steps(),
               plan.steps * scene.disks.replicas);
  std::vector<std::optional<Snapshot>> snapshots;
  for (auto& system : checkpoint.systems) {
    run.replicas.push_back(replica_of(system));
    snapshots.push_back(snapshot_of(system));
  }
  Runner runner(folder, std::move(run), machine, quiet);
  runner.start(std::move(snapshots));
  return runner.run(protocol_of(plan));
}

}  // namespace

void warn(std::string const& message) {
  if (!message.empty()) fmt::print(stderr, "bagnold: warning: {}\n", message);
}

int run_command(RunOptions const& options) {
  Scene scene = read_scene(options.scene_file, options.overrides);
  Plan const plan = make_plan(scene);
  check_feasible(scene, plan, options.allow_unstable);
  warn(plan_warning(plan));
  scene.integration.time_step = plan.time_step;  // resolved
  Machine const machine = choose(options.machine, scene);
  auto from_file = states_in_file(scene);

  auto const name = options.folder.empty()
                        ? std::filesystem::path("results") / options.scene_file.stem()
                        : options.folder;
  catch_signals();
  RunFolder const folder = RunFolder::make(name, options.force);
  RunFolder::write_text(folder.scene(), write_scene(scene));
  return run_from_start(folder, scene, plan, machine, options.quiet, std::move(from_file));
}

int resume_command(ResumeOptions const& options) {
  catch_signals();
  RunFolder const folder = RunFolder::open(options.folder);
  if (std::filesystem::exists(folder.summary())) {
    folder.remove_trajectory_parts();
    fmt::print("{} is finished: nothing to resume\n", options.folder.string());
    return 0;
  }
  std::vector<std::string> remarks;
  auto checkpoint = io::newest_checkpoint(folder.path(), &remarks);
  for (auto const& remark : remarks) fmt::print(stderr, "bagnold: {}\n", remark);
  if (checkpoint && std::filesystem::exists(folder.scene()) &&
      read_text(folder.scene()) != checkpoint->scene)
    throw InputError(
        fmt::format("{} is not the scene of the checkpoint beside it; put it back, or "
                    "start a new run with it in another folder",
                    folder.scene().string()));
  if (checkpoint)
    return run_from_checkpoint(folder, std::move(*checkpoint), options.machine, options.quiet);

  fmt::print(stderr,
             "bagnold: no checkpoint in {} can be used: starting again from its scene.toml\n",
             options.folder.string());
  Scene const scene = read_scene(folder.scene());
  return run_from_start(folder, scene, make_plan(scene), choose(options.machine, scene),
                        options.quiet, states_in_file(scene));
}

}  // namespace bagnold
