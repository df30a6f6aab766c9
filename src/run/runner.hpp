// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "src/engine/simulation.hpp"
#include "src/io/checkpoint.hpp"
#include "src/run/machine.hpp"
#include "src/run/monitor.hpp"
#include "src/run/replica_scheduler.hpp"
#include "src/run/results.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

/// A run in its folder: its replicas side by side, or together on a device; steps, checkpoints,
/// results.
///
/// Where the scene has a target error, all replicas are taken to the same number of windows, from a
/// grid that depends on nothing else (src/statistics/stopping.hpp), before it is seen whether that
/// is enough.
class Runner {
 public:
  Runner(RunFolder const& folder, Run run, Machine const& machine, RunMonitor& monitor);

  /// Simulations of these snapshots, [R]; an empty one is a random start yet to be made. All are
  /// made side by side. NumericalError names the replica and leaves its state in the folder.
  /// False where the monitor stopped it.
  bool start(std::vector<std::optional<Snapshot>> snapshots);

  /// Takes all replicas to the end, unless the monitor stops them.
  RunEnd run();

 private:
  Snapshot start_of(std::size_t replica, std::optional<Snapshot> snapshot,
                    std::function<bool()> const& go_on);
  void make(std::size_t replica, Snapshot snapshot);
  void make_all_together(std::vector<Snapshot> const& snapshots);
  std::unique_ptr<Simulation> simulation_of(std::size_t r, Snapshot&& snapshot) const;
  Plan next_leg() const;  ///< to where the target error is looked at next
  bool enough();          ///< whether the run may end there
  bool is_last_leg() const { return run_.plan.windows == whole_.windows; }
  bool work_on_leg(ReplicaScheduler& all);
  void make_frames_of(std::size_t replica, State const& start);
  void add_observers(std::size_t replica);  ///< once it has its simulation and its frames
  std::int64_t seed(std::size_t replica) const;
  bool work(ReplicaScheduler& all);
  bool step_on(std::size_t replica, std::function<bool()> const& go_on);
  std::int64_t steps() const;         ///< of all replicas together
  std::int64_t steps_wanted() const;  ///< likewise, at the end of the leg
  void note_engine(std::size_t replica, Snapshot const& at);
  ReplicaScheduler::Request request() const;
  io::SystemCheckpoint checkpoint_of(std::size_t replica);
  void write_checkpoint();
  void checkpoint();  ///< and what has been measured so far
  void say_where_it_stopped() const;
  void finish();
  /// Those that can be; the first failure, or nothing.
  std::string join_trajectories();

  using SteadyClock = std::chrono::steady_clock;

  RunFolder const& folder_;
  Run run_;     ///< its plan ends where this leg does
  Plan whole_;  ///< to where the strain is spent
  Machine machine_;
  RunMonitor& monitor_;
  LegEnd leg_end_ = LegEnd::exact;
  bool together_;  ///< replicas share launches: for ReplicaScheduler all are one system
  std::vector<std::unique_ptr<Simulation>> simulations_;  ///< [R]
  std::vector<std::atomic<std::int64_t>> steps_;          ///< [R], seen while others step
  double wall_before_;
  SteadyClock::time_point started_;
  SteadyClock::time_point checkpointed_;
  /// The next checkpoint after 10 s of stepping, 30 s, 90 s, ...: what users look at, `bagnold
  /// status` and `bagnold plot`, reads checkpoints.
  double early_checkpoint_ = 10;
};

}  // namespace bagnold
