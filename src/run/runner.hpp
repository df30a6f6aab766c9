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
/// If the scene has a target error, all replicas are advanced to the same number of windows before
/// the target is checked. These numbers are from a grid that depends on nothing else
/// (src/statistics/stopping.hpp).
class Runner {
 public:
  Runner(RunFolder const& folder, Run run, Machine const& machine, RunMonitor& monitor);

  /// Makes simulations of these snapshots, [R]; an empty one is a random start yet to be made. All
  /// are made side by side. NumericalError names the replica and leaves its state in the folder.
  /// Returns false if the monitor stopped it.
  bool start(std::vector<std::optional<Snapshot>> snapshots);

  /// Advances all replicas to the end, unless the monitor stops them.
  RunEnd run();

 private:
  Snapshot start_of(std::size_t replica, std::optional<Snapshot> snapshot,
                    std::function<bool()> const& go_on);
  void make(std::size_t replica, Snapshot snapshot);
  void make_all_together(std::vector<Snapshot> const& snapshots);
  std::unique_ptr<Simulation> simulation_of(std::size_t r, Snapshot&& snapshot) const;
  Plan next_leg() const;  ///< up to the next check of the target error
  bool enough();          ///< true if the run may end there
  bool is_last_leg() const { return run_.plan.windows == whole_.windows; }
  bool work_on_leg(ReplicaScheduler& all);
  void make_frames_of(std::size_t replica, State const& start);
  void add_observers(std::size_t replica);  ///< once it has its simulation and its frames
  void control(std::size_t replica);
  std::int64_t seed(std::size_t replica) const;
  std::string chosen_method() const;
  bool work(ReplicaScheduler& all);
  bool step_on(std::size_t replica, std::function<bool()> const& go_on);
  std::int64_t steps() const;         ///< of all replicas together
  std::int64_t steps_wanted() const;  ///< of all replicas, at the end of the leg
  void measure_bias();                ///< makes what pairs need, if the scene asks for them
  void say_changes();                 ///< of the method, by scheme = "auto"
  void drop_refused();                ///< leaves out windows of a method that was refused since
  Plan without(std::int64_t dropped) const;  ///< whole_, but for so many steps of a refused method
  bool awaits_pairs() const;  ///< true if a replica has still to take one where it is
  void note_engine(std::size_t replica, Snapshot const& at);
  ReplicaScheduler::Request request() const;
  io::SystemCheckpoint checkpoint_of(std::size_t replica);
  void write_checkpoint();
  void checkpoint();  ///< and what has been measured so far
  void say_where_it_stopped() const;
  void finish();
  /// Joins the parts of all trajectories that can be joined. Returns the first failure, or "".
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
  std::vector<std::atomic<std::int64_t>> steps_;          ///< [R], read while others step
  std::unique_ptr<bias::SharedCourse> course_;            ///< of the method; null: not asked for
  std::size_t said_changes_ = 0;
  std::vector<bias::ReplicaPairs> pairs_;  ///< [R], or empty
  double wall_before_;
  SteadyClock::time_point started_;
  SteadyClock::time_point checkpointed_;
  /// Next checkpoint after 10 s of stepping, 30 s, 90 s, ...: early ones are for `bagnold status`
  /// and `bagnold plot`, which read checkpoints.
  double early_checkpoint_ = 10;
};

}  // namespace bagnold
