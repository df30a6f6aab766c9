// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "kernels/core/kokkos_compat.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/plot.hpp"
#include "src/cli/progress.hpp"
#include "src/cli/provenance.hpp"
#include "src/cli/run_folder.hpp"
#include "src/cli/run_results.hpp"
#include "src/cli/signals.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/toml_text.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/state_file.hpp"
#include "src/measure/make_frames.hpp"
#include "src/simulation/make_simulation.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

using SteadyClock = std::chrono::steady_clock;

/// Threads and backend where the user left them open: a thread for every 4096 disks, as far as there
/// are cores (fewer wait for each other more than they work); one thread runs on Serial. The bits do
/// not depend on it.
Machine choose(Machine machine, Scene const& scene) {
  auto const has = [](std::string const& name) {
    auto const all = backend_names();
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  if (!machine.backend.empty() && !has(machine.backend))
    throw InputError(fmt::format("--backend {}: not in this build (has: {})", machine.backend,
                                 fmt::join(backend_names(), ", ")));
  if (machine.threads == 0) {
    auto const cores = static_cast<std::int64_t>(std::max(1u, std::thread::hardware_concurrency()));
    machine.threads = static_cast<int>(std::clamp<std::int64_t>(scene.disks.count / 4096, 1, cores));
  }
  if (machine.backend.empty())
    machine.backend = machine.threads > 1 && has("openmp") ? "openmp" : backend_names().front();
  if (machine.backend == "serial") machine.threads = 1;
  return machine;
}

struct KokkosScope {
  explicit KokkosScope(int threads) { initialize_kokkos(threads); }
  ~KokkosScope() { Kokkos::finalize(); }
};

Snapshot snapshot_of(State state) {
  Snapshot snapshot;
  snapshot.initial_offset = state.offset;
  snapshot.initial_time = state.time;
  snapshot.state = std::move(state);
  return snapshot;
}

/// Leave the state to look at, and go on failing.
[[noreturn]] void fail(RunFolder const& folder, NumericalError const& error, State const& state) {
  io::write_state(folder.failed_state(), state);
  throw NumericalError(
      fmt::format("{}; the state is in {}", error.what(), folder.failed_state().string()));
}

std::unique_ptr<Simulation> begin(RunFolder const& folder, Scene const& scene,
                                  Snapshot const& snapshot, std::string const& backend) {
  try {
    return make_simulation(scene, snapshot, backend);
  } catch (NumericalError const& error) {
    fail(folder, error, snapshot.state);
  }
}

/// A run in its folder: steps, checkpoints, results.
class Runner {
 public:
  Runner(RunFolder const& folder, Run run, std::unique_ptr<Simulation> simulation, bool quiet)
      : folder_(folder), run_(std::move(run)), simulation_(std::move(simulation)), quiet_(quiet),
        wall_before_(run_.wall_seconds) {}

  int run() {
    started_ = checkpointed_ = SteadyClock::now();
    Progress progress(run_.scene, run_.plan, simulation_->step(), quiet_);
    auto const go_on = [&] {
      progress.show(simulation_->step());
      auto const since = SteadyClock::now() - checkpointed_;
      bool const due = std::chrono::duration<double>(since).count() >
                       60 * run_.scene.output.checkpoint_minutes;
      if (checkpoint_requested() || due) checkpoint();
      return stop_signal() == 0;
    };
    bool finished = false;
    try {
      finished = run_steady(*simulation_, run_.plan, run_.measurement, go_on);
    } catch (NumericalError const& error) {
      fail(folder_, error, simulation_->state());
    }
    progress.finish(simulation_->step());
    checkpoint();
    if (!finished && simulation_->step() < run_.plan.steps) return interrupted();
    finish();
    return 0;
  }

 private:
  void checkpoint() {
    run_.wall_seconds = wall_before_ +
                        std::chrono::duration<double>(SteadyClock::now() - started_).count();
    Snapshot snapshot = simulation_->snapshot();
    io::Checkpoint c;
    c.scene = write_scene(run_.scene);
    c.state = std::move(snapshot.state);
    c.list_position = std::move(snapshot.list_position);
    c.list_step = snapshot.list_step;
    c.step = snapshot.step;
    c.initial_offset = snapshot.initial_offset;
    c.initial_time = snapshot.initial_time;
    c.builds = snapshot.list_builds;
    c.engine = run_.engine = std::move(snapshot.engine);
    c.columns = simulation_->columns();
    c.window_sums = run_.measurement.windows.sums;
    c.window_weight = run_.measurement.windows.weight;
    if (!run_.measurement.open.sums.empty()) {  // one at most: an engine stops where it has caught up
      c.open_sums = run_.measurement.open.sums.front().sums;
      c.open_weight = run_.measurement.open.sums.front().weight;
    }
    c.start_record = run_.start_record;
    c.wall_seconds = run_.wall_seconds;
    c.frames = run_.measurement.frames.save();
    io::write_checkpoint(folder_.path(), c);
    write_result_file(folder_, run_);
    checkpointed_ = SteadyClock::now();
  }

  int interrupted() const {
    fmt::print(stderr, "bagnold: stopped at step {} of {}; `bagnold resume {}` goes on\n",
               simulation_->step(), run_.plan.steps, folder_.path().string());
    return 128 + stop_signal();
  }

  void finish() {
    run_.measurement.frames.finish();
    io::write_state(folder_.state(), simulation_->state());
    auto const list = estimates(run_);
    write_summary(folder_, run_, list);
    run_.measurement.frames.tidy();
    if (run_.scene.output.plot) {  // shows the summary's errors
      warn(draw_plot(folder_.result(), folder_.picture()));
      if (run_.scene.measure.profiles || run_.scene.measure.fields)
        warn(draw_frames(folder_.result(), folder_.path()));
    }
    if (quiet_) return;
    print_table(run_, list);
    fmt::print("\nresults in {}\n", folder_.path().string());
  }

  RunFolder const& folder_;
  Run run_;
  std::unique_ptr<Simulation> simulation_;
  bool quiet_;
  double wall_before_;
  SteadyClock::time_point started_;
  SteadyClock::time_point checkpointed_;
};

/// The first state of a scene; a state file is read before anything is written.
StartedState start_of(Scene const& scene) {
  if (scene.start.kind == "state") return fit_to_scene(io::read_state(scene.start.file), scene);
  return random_start(scene);
}

int run_from_start(RunFolder const& folder, Scene const& scene, Plan const& plan,
                   Machine const& machine, bool quiet, std::optional<StartedState> started) {
  KokkosScope const kokkos(machine.threads);
  if (!started) {
    if (!quiet) fmt::print("relaxing the overlaps of {} random disks\n", scene.disks.count);
    started = start_of(scene);
  }
  Run run;
  run.scene = scene;
  run.plan = plan;
  run.box_length = started->state.box_length;
  run.initial_time = started->state.time;
  run.start_record = started->record;
  run.backend = machine.backend;
  auto simulation =
      begin(folder, scene, snapshot_of(std::move(started->state)), machine.backend);
  run.measurement.windows.columns = static_cast<std::size_t>(simulation->columns());
  run.measurement.frames =
      make_frames(scene, plan, simulation->state(), folder.trajectory(), provenance().version);
  run.measurement.frames.begin();
  return Runner(folder, std::move(run), std::move(simulation), quiet).run();
}

int run_from_checkpoint(RunFolder const& folder, io::Checkpoint checkpoint, Machine machine,
                        bool quiet) {
  Scene const scene = parse_scene(checkpoint.scene, "scene in the checkpoint", folder.path());
  machine = choose(machine, scene);
  KokkosScope const kokkos(machine.threads);
  Run run;
  run.scene = scene;
  run.plan = make_plan(scene);
  run.box_length = checkpoint.state.box_length;
  run.initial_time = checkpoint.initial_time;
  run.start_record = checkpoint.start_record;
  run.backend = machine.backend;
  run.wall_seconds = checkpoint.wall_seconds;
  run.measurement.windows = {static_cast<std::size_t>(checkpoint.columns),
                             std::move(checkpoint.window_sums),
                             std::move(checkpoint.window_weight)};
  run.measurement.open.first = static_cast<std::int64_t>(run.measurement.windows.size());
  run.measurement.open.sums = {{std::move(checkpoint.open_sums), checkpoint.open_weight}};
  Snapshot snapshot;
  snapshot.state = std::move(checkpoint.state);
  snapshot.list_position = std::move(checkpoint.list_position);
  snapshot.list_step = checkpoint.list_step;
  snapshot.step = checkpoint.step;
  snapshot.initial_offset = checkpoint.initial_offset;
  snapshot.initial_time = checkpoint.initial_time;
  snapshot.list_builds = checkpoint.builds;
  snapshot.engine = std::move(checkpoint.engine);
  if (!quiet) fmt::print("going on from step {} of {}\n", snapshot.step, run.plan.steps);
  auto simulation = begin(folder, scene, snapshot, machine.backend);
  run.measurement.frames =
      make_frames(scene, run.plan, snapshot.state, folder.trajectory(), provenance().version);
  run.measurement.frames.load(checkpoint.frames);
  return Runner(folder, std::move(run), std::move(simulation), quiet).run();
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
  std::optional<StartedState> from_file;
  if (scene.start.kind == "state") from_file = start_of(scene);

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
    throw InputError(fmt::format("{} is not the scene of the checkpoint beside it; put it back, or "
                                 "start a new run with it in another folder",
                                 folder.scene().string()));
  if (checkpoint)
    return run_from_checkpoint(folder, std::move(*checkpoint), options.machine, options.quiet);

  fmt::print(stderr, "bagnold: no checkpoint in {} can be used: starting again from its scene.toml\n",
             options.folder.string());
  Scene const scene = read_scene(folder.scene());
  std::optional<StartedState> from_file;
  if (scene.start.kind == "state") from_file = start_of(scene);
  return run_from_start(folder, scene, make_plan(scene), choose(options.machine, scene),
                        options.quiet, std::move(from_file));
}

}  // namespace bagnold
