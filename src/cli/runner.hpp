// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "src/cli/machine.hpp"
#include "src/cli/run_folder.hpp"
#include "src/cli/run_results.hpp"
#include "src/io/checkpoint.hpp"
#include "src/protocols/side_by_side.hpp"
#include "src/simulation/simulation.hpp"

namespace bagnold {

/// How one system is taken through its run: which rates, which windows. Goes on from wherever the
/// system is until all is done (returns true) or `go_on`, asked about twenty times a second, says
/// no.
using Protocol = std::function<bool(Simulation&, Measurement&, std::function<bool()> const& go_on)>;

/// A run in its folder: its replicas side by side, steps, checkpoints, results.
class Runner {
 public:
  Runner(RunFolder const& folder, Run run, Machine const& machine, bool quiet);

  /// Simulations of these snapshots, [R]; an empty one is a random start yet to be made. All are
  /// made side by side. NumericalError names the replica and leaves its state in the folder.
  void start(std::vector<std::optional<Snapshot>> snapshots);

  /// Takes all replicas through the protocol. Returns the exit code: 0 done, 128 + signal stopped.
  int run(Protocol const& protocol);

 private:
  void make(std::size_t replica, std::optional<Snapshot> snapshot);
  void watch(std::size_t replica, State const& start);  ///< makes its frames
  std::int64_t seed(std::size_t replica) const;
  bool work(SideBySide& all);
  std::int64_t steps() const;         ///< of all replicas together
  std::int64_t steps_wanted() const;  ///< likewise, in the end
  SideBySide::Wish wish() const;
  io::SystemCheckpoint checkpoint_of(std::size_t replica);
  void checkpoint();
  int interrupted() const;
  void finish();

  using SteadyClock = std::chrono::steady_clock;

  RunFolder const& folder_;
  Run run_;
  Machine machine_;
  bool quiet_;
  std::vector<std::unique_ptr<Simulation>> simulations_;  ///< [R]
  std::vector<std::atomic<std::int64_t>> steps_;          ///< [R], seen while others step
  double wall_before_;
  SteadyClock::time_point started_;
  SteadyClock::time_point checkpointed_;
};

}  // namespace bagnold
