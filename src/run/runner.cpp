// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/config/errors.hpp"
#include "src/config/ladder.hpp"
#include "src/config/names.hpp"
#include "src/config/piece_table.hpp"
#include "src/config/scene_file.hpp"
#include "src/engine/control_columns.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/io/state_file.hpp"
#include "src/measure/contacts.hpp"
#include "src/measure/make_frames.hpp"
#include "src/run/bias/methods.hpp"
#include "src/run/messages.hpp"
#include "src/run/pictures.hpp"
#include "src/run/protocols/cascade/cascade.hpp"
#include "src/run/provenance.hpp"
#include "src/run/run_measured.hpp"
#include "src/run/target_error.hpp"
#include "src/run/warnings/warning.hpp"
#include "src/start/relax_overlaps.hpp"
#include "src/start/start.hpp"
#include "src/statistics/stopping.hpp"

namespace bagnold {

namespace {

/// Number of disks from which on a stop does not wait for the end of a start, which can take long.
constexpr std::int64_t long_start = 8192;

/// A NumericalError with its replica, on its way to the thread that writes files.
struct ReplicaFailure {
  std::size_t replica;
  std::string reason;
  std::optional<State> state;  ///< none where there was no start
};

}  // namespace

Runner::Runner(RunFolder const& folder, Run run, Machine const& machine, RunMonitor& monitor)
    : folder_(folder),
      run_(std::move(run)),
      whole_(run_.plan),
      machine_(machine),
      monitor_(monitor),
      together_(steps_together(run_.scene, machine_.backend)),
      simulations_(run_.replicas.size()),
      steps_(run_.replicas.size()),
      wall_before_(run_.wall_seconds) {
  bool const chooses = may_change_method(run_.scene) && !is_device_backend(machine_.backend);
  if (run_.scene.measure.bias || chooses) measure_bias();
}

void Runner::measure_bias() {
  auto const replicas = run_.replicas.size();
  course_.reset(new bias::SharedCourse{{}, {run_.scene, replicas}, machine_.backend});
  for (std::size_t r = 0; r < replicas; ++r) course_->course.load(r, run_.replicas[r].saved_pairs);
  for (std::size_t r = 0; r < replicas; ++r)
    pairs_.emplace_back(*course_, r, [this, r](std::int64_t dropped) {
      run_.replicas[r].measurement.frames.forget_before(without(dropped).first_step());
    });
  said_changes_ = course_->course.changes().size();
  drop_refused();
}

void Runner::say_changes() {
  if (!course_) return;
  std::lock_guard const lock(course_->mutex);
  for (auto const& all = course_->course.changes(); said_changes_ < all.size(); ++said_changes_)
    monitor_.status(all[said_changes_]);
}

void Runner::drop_refused() {
  if (!course_) return;
  std::lock_guard const lock(course_->mutex);
  auto const dropped = course_->course.dropped();
  if (dropped / whole_.window_steps == whole_.dropped_windows) return;
  whole_ = without(dropped);
  run_.plan = shortened(run_.scene, whole_, run_.plan.windows);
}

Plan Runner::without(std::int64_t dropped) const {
  Plan plan = whole_;
  plan.dropped_windows = dropped / plan.window_steps;
  return shortened(run_.scene, plan, plan.windows);
}

bool Runner::start(std::vector<std::optional<Snapshot>> snapshots) {
  std::vector<Snapshot> starts(snapshots.size());
  ReplicaScheduler all;
  all.systems = run_.replicas.size();
  all.turn = std::chrono::hours(24 * 365);  // a start is not taken up again
  if (run_.scene.disks.count >= long_start)
    all.request = [&] {
      return monitor_.stop_requested() ? ReplicaScheduler::Request::stop
                                       : ReplicaScheduler::Request::go_on;
    };
  all.advance = [&](std::size_t r, auto const& go_on) {
    try {
      starts[r] = start_of(r, std::move(snapshots[r]), go_on);
    } catch (StartStopped const&) {
      return false;
    }
    if (!together_) make(r, std::exchange(starts[r], {}));
    return true;
  };
  if (!work(all)) {
    say(stopped_before_the_first_step(run_.scene, folder_.path()));
    return false;
  }
  if (together_) make_all_together(starts);
  return true;
}

Snapshot Runner::start_of(std::size_t r, std::optional<Snapshot> snapshot,
                          std::function<bool()> const& go_on) {
  Replica& replica = run_.replicas[r];
  if (!snapshot) {
    Scene scene = run_.scene;
    scene.disks.seed = seed(r);
    if (whole_.ramp) scene.shear.strain_rate = whole_.ramp->piece(0).rate;
    if (whole_.pieces) scene.shear.strain_rate = (*whole_.pieces)[0].rate;
    StartedState started;
    try {
      started = random_start(scene, go_on);
    } catch (NumericalError const& error) {
      throw ReplicaFailure{r, error.what(), {}};
    }
    replica.start_record = std::move(started.record);
    snapshot = first_snapshot(std::move(started.state));
  }
  replica.initial_time = snapshot->initial_time;
  replica.box_length = snapshot->state.box_length;
  if (r == 0)  // of a controlled run where it began
    run_.box_length =
        run_.scene.shear.controlled() ? run_.scene.box_length() : snapshot->state.box_length;
  return *std::move(snapshot);
}

void Runner::make(std::size_t r, Snapshot snapshot) {
  make_frames_of(r, snapshot.state);
  try {
    simulations_[r] = simulation_of(r, std::move(snapshot));
  } catch (NumericalError const& error) {
    throw ReplicaFailure{r, error.what(), snapshot.state};
  }
  add_observers(r);
}

void Runner::make_all_together(std::vector<Snapshot> const& snapshots) {
  simulations_ = make_simulations(run_.scene, snapshots, machine_.backend);
  for (std::size_t r = 0; r < snapshots.size(); ++r) {
    make_frames_of(r, snapshots[r].state);
    add_observers(r);
  }
}

std::unique_ptr<Simulation> Runner::simulation_of(std::size_t r, Snapshot&& snapshot) const {
  Scene scene = run_.scene;
  scene.disks.seed = seed(r);
  return make_simulation(scene, std::move(snapshot), machine_.backend);
}

void Runner::make_frames_of(std::size_t r, State const& start) {
  auto const file =
      folder_.trajectory(run_.replicas.size() > 1 ? std::optional(seed(r)) : std::nullopt);
  Scene scene = run_.scene;
  scene.disks.seed = seed(r);
  run_.replicas[r].measurement.frames =
      make_frames(scene, run_.plan, start, file, provenance().version);
}

void Runner::add_observers(std::size_t r) {
  Replica& replica = run_.replicas[r];
  Frames& frames = replica.measurement.frames;
  steps_[r] = simulations_[r]->step();
  auto const columns = simulations_[r]->columns();
  replica.measurement.windows.columns = static_cast<std::size_t>(columns);
  if (run_.scene.shear.controlled()) control(r);
  if (run_.scene.measure.contacts) {
    replica.measurement.open.contacts =
        watch_contacts(run_.scene, run_.plan, columns, seed(r), frames);
    replica.measurement.windows.columns += ContactColumns::count;
  }
  if (!replica.saved_frames) return frames.begin();
  frames.load(*std::exchange(replica.saved_frames, {}));
  auto const first = whole_.first_step();
  auto const dropped = whole_.dropped_windows * whole_.window_steps;
  bool const none_yet = dropped > 0 && (steps_[r] < first || steps_[r] <= dropped);
  if (replica.discards_more || none_yet) frames.forget_before(first);
  if (replica.discards_more) frames.show_first_again(*simulations_[r]);
  for (auto const& lost : frames.lost()) warn(lost);
}

/// Puts a controller over a replica, with what it remembers of a checkpoint.
void Runner::control(std::size_t r) {
  Replica& replica = run_.replicas[r];
  auto& measurement = replica.measurement;
  measurement.controller = make_controller(run_.scene, run_.plan, replica.box_length);
  if (!replica.saved_control.empty()) measurement.controller->load(replica.saved_control);
  measurement.windows.columns += ControlColumns::count;
  measurement.open.first = steps_[r] / run_.plan.control_steps;
}

std::int64_t Runner::seed(std::size_t r) const {
  return run_.scene.disks.seed + static_cast<std::int64_t>(r);
}

Plan Runner::next_leg() const {
  std::int64_t done = run_.plan.windows < whole_.windows ? run_.plan.windows + 1 : 0;
  for (auto const& replica : run_.replicas)
    done = std::max(done, static_cast<std::int64_t>(replica.measurement.windows.size()));
  return shortened(run_.scene, whole_, statistics::next_look(done, whole_.windows));
}

bool Runner::enough() {
  drop_refused();
  judge_errors(run_);
  return run_.plan.windows == whole_.windows || run_.target_met;
}

RunEnd Runner::run() {
  started_ = checkpointed_ = SteadyClock::now();
  monitor_.begin(run_.scene, run_.plan, steps());
  ReplicaScheduler all;
  all.systems = together_ ? 1 : run_.replicas.size();
  all.advance = [&](std::size_t r, auto const& go_on) { return step_on(r, go_on); };
  all.request = [&] {
    say_changes();
    monitor_.progress(steps());
    return request();
  };
  all.held = [&] { checkpoint(); };
  bool done = false;
  do {
    if (!run_.scene.shear.target_error.empty()) run_.plan = next_leg();
    done = work_on_leg(all) && enough();
  } while (!done && !monitor_.stop_requested());
  say_changes();
  monitor_.end(steps());
  if (!done || !is_last_leg()) checkpoint();
  if (done)
    finish();
  else
    say_where_it_stopped();
  return done ? RunEnd::done : RunEnd::stopped;
}

bool Runner::awaits_pairs() const {
  for (std::size_t r = 0; r < pairs_.size(); ++r)
    if (pairs_[r].awaited(steps_[r])) return true;
  return false;
}

/// The checkpoint of the last leg is before a lookahead that the end of the run cuts short. A run
/// that is made longer continues from there with the bits of one that was as long from its start.
bool Runner::work_on_leg(ReplicaScheduler& all) {
  auto const ended = [&] { return work(all) || (steps() == steps_wanted() && !awaits_pairs()); };
  leg_end_ = is_last_leg() ? LegEnd::whole : LegEnd::exact;
  if (!ended()) return false;
  if (!is_last_leg()) return true;
  write_checkpoint();
  leg_end_ = LegEnd::exact;
  if (course_) course_->ended = true;  // a longer run would stop elsewhere
  auto to_the_end = all;               // a lookahead or less, without turns
  to_the_end.request = [] { return ReplicaScheduler::Request::go_on; };
  auto const before = SteadyClock::now();
  bool const done = work(to_the_end);
  run_.wall_seconds += std::chrono::duration<double>(SteadyClock::now() - before).count();
  return done;
}

/// Advances one replica, or all if they step together.
bool Runner::step_on(std::size_t first, std::function<bool()> const& go_on) {
  std::size_t const end = together_ ? simulations_.size() : first + 1;
  std::vector<MeasuredSystem> systems;
  for (auto r = first; r < end; ++r)
    systems.push_back(
        {*simulations_[r], run_.replicas[r].measurement, pairs_.empty() ? nullptr : &pairs_[r]});
  try {
    return run_measured(
        systems, run_.plan,
        [&] {
          for (auto r = first; r < end; ++r) steps_[r] = simulations_[r]->step();
          return go_on();
        },
        leg_end_);
  } catch (SystemFailure const& failure) {
    auto const r = first + failure.system;
    throw ReplicaFailure{r, failure.what() + chosen_method(), simulations_[r]->state()};
  }
}

/// What to do where a step fails of a method that the run chose itself; "" if it did not.
std::string Runner::chosen_method() const {
  if (!course_ || !course_->course.chooses()) return "";
  std::lock_guard const lock(course_->mutex);
  auto const ladder = ladder_of(run_.scene);
  auto const method = course_->course.method();
  if (method >= ladder.usual) return "";
  auto const chosen = with_method(run_.scene, ladder.methods[method]);
  return fmt::format("; scheme = \"auto\" had taken {}: name integration.scheme = \"{}\"",
                     bias::method_in_words(chosen), default_scheme);
}

bool Runner::work(ReplicaScheduler& all) {
  all.threads = all.systems > 1 ? machine_.threads : 1;
  try {
    return bagnold::run(all);
  } catch (ReplicaFailure const& failure) {
    std::string message = failure.reason;
    if (run_.replicas.size() > 1)
      message = fmt::format("replica {} (seed {}): {}", failure.replica + 1, seed(failure.replica),
                            message);
    if (failure.state) {
      io::write_states(folder_.failed_state(), {*failure.state});
      message += fmt::format("; the state is in {}", folder_.failed_state().string());
    }
    throw NumericalError(message);
  }
}

std::int64_t Runner::steps() const {
  std::int64_t sum = 0;
  for (auto const& one : steps_) sum += one;
  return sum;
}

std::int64_t Runner::steps_wanted() const { return run_.plan.steps * run_.scene.disks.replicas; }

ReplicaScheduler::Request Runner::request() const {
  if (monitor_.stop_requested()) return ReplicaScheduler::Request::stop;
  auto const now = SteadyClock::now();
  std::chrono::duration<double> const since = now - checkpointed_, stepping = now - started_;
  bool const due = since.count() > 60 * run_.scene.output.checkpoint_minutes ||
                   stepping.count() > early_checkpoint_;
  return monitor_.checkpoint_requested() || due ? ReplicaScheduler::Request::hold
                                                : ReplicaScheduler::Request::go_on;
}

void Runner::note_engine(std::size_t r, Snapshot const& at) {
  auto& engine = run_.replicas[r].engine;
  engine = at.memory;
  engine.insert(at.counters.begin(), at.counters.end());
}

io::SystemCheckpoint Runner::checkpoint_of(std::size_t r) {
  Replica& replica = run_.replicas[r];
  io::SystemCheckpoint c;
  simulations_[r]->give_back_scratch();
  static_cast<Snapshot&>(c) = simulations_[r]->snapshot();
  note_engine(r, c);
  auto& [windows, open, frames, controller] = replica.measurement;
  if (controller) c.arrays[controller_name] = controller->memory();
  if (course_) c.arrays[bias::pairs_name] = pairs_[r].save();
  c.columns = static_cast<std::int64_t>(windows.columns);
  c.window_sums = windows.sums;
  c.window_weight = windows.weight;
  if (!open.sums.empty()) {  // one at most: an engine stops where it has caught up
    c.open_sums = open.sums.front().sums;
    c.open_weight = open.sums.front().weight;
  }
  c.start_record = replica.start_record;
  c.frames = frames.save();
  return c;
}

void Runner::write_checkpoint() {
  folder_.check();
  std::chrono::duration<double> const stepping = SteadyClock::now() - started_;
  run_.wall_seconds = wall_before_ + stepping.count();
  io::Checkpoint c;
  c.scene = write_scene(run_.scene);
  c.simd = level_of(run_.scene.disks.model, run_.scene.drive.kind).name;
  c.wall_seconds = run_.wall_seconds;
  for (std::size_t r = 0; r < simulations_.size(); ++r) c.systems.push_back(checkpoint_of(r));
  io::write_checkpoint(folder_.path(), std::move(c));
  checkpointed_ = SteadyClock::now();
  while (early_checkpoint_ < stepping.count()) early_checkpoint_ *= 3;
}

void Runner::checkpoint() {
  write_checkpoint();
  drop_refused();
  discard_transient(run_);
  write_result_file(folder_, run_);
}

void Runner::say_where_it_stopped() const {
  say(fmt::format("stopped at step {} of {}{}; {} goes on", steps(),
                  whole_.steps * run_.scene.disks.replicas,
                  simulations_.size() > 1 ? ", all replicas together" : "",
                  resuming(run_.scene, folder_to_resume(folder_.path()))));
}

std::string Runner::join_trajectories() {
  std::string failure;
  for (auto& replica : run_.replicas) try {
      replica.measurement.frames.finish();
      replica.measurement.frames.tidy();
    } catch (FileError const& error) {
      if (failure.empty()) failure = error.what();
    }
  return failure;
}

void Runner::finish() {
  folder_.check();
  std::vector<State> states;
  for (std::size_t r = 0; r < simulations_.size(); ++r) {
    simulations_[r]->give_back_scratch();
    note_engine(r, simulations_[r]->snapshot());
    states.push_back(simulations_[r]->state());
    run_.replicas[r].end_motion = mean_motion(states.back(), run_.scene);
  }
  if (course_) run_.bias = course_->course.findings();
  write_result_file(folder_, run_);
  io::write_states(folder_.state(), std::move(states));
  auto const list = estimates(run_);
  drop_pictures(folder_);  // `bagnold plot` may have drawn some on the way
  FinishedRun const finished{run_, list};
  auto const suspect = warnings(finished);
  write_summary(folder_, run_, list, suspect);
  auto const not_joined = join_trajectories();
  draw_missing_pictures(folder_, run_.scene);  // they show the summary's errors
  monitor_.finished(folder_, finished, suspect);
  if (!not_joined.empty())
    throw FileError(fmt::format("all results are written but the trajectory: {}", not_joined));
}

}  // namespace bagnold
