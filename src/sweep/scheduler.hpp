// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "src/sweep/child.hpp"
#include "src/sweep/monitor.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/sweep_folder.hpp"

namespace bagnold::sweep {

/// Command and number of jobs for points.
struct Work {
  std::vector<std::string> command;  ///< before the point's folder: program and "resume"
  std::vector<std::string> options;  ///< behind it
  std::size_t jobs = 1;              ///< points at a time
};

/// A point that ended without a result.
struct Failure {
  std::size_t point = 0;
  int exit_code = 0;
  std::string reason;  ///< what it said last
};

/// Runs chains of points as processes of their own, as many at a time as there are jobs, each chain
/// in its order. Finished points are skipped; a point that fails ends its chain and nothing else.
class Scheduler {
 public:
  Scheduler(Sweep const& sweep, SweepFolder const& folder, Work work, SweepMonitor& monitor);

  /// Runs until all is done or, if the monitor asks to stop, until every point has written its
  /// checkpoint and stopped. Returns failures, in the file's order. FileError if the system starts
  /// no process; running points have then written their checkpoints.
  std::vector<Failure> run(std::vector<std::size_t> const& chains);

 private:
  struct Chain {
    std::vector<std::size_t> points;
    std::size_t next = 0;  ///< the first that is neither finished nor running
    bool busy = false;
    bool over() const { return next == points.size(); }
  };

  struct Running {
    Child child;
    Chain* chain;
    std::uintmax_t log_before;  ///< bytes in the log when it started
  };

  void stop();
  void start_points();
  void start(Chain& chain, std::size_t point);
  bool let_go(std::size_t point);
  void wait() const;
  void look_at_points();
  bool all_are_asked_to_stop(int signal) const;
  void ended(Running const& running, std::size_t point, int exit_code);
  bool pending() const;

  Sweep const& sweep_;
  SweepFolder const& folder_;
  Work work_;
  SweepMonitor& monitor_;
  std::vector<Chain> chains_;
  std::map<std::size_t, Running> running_;  ///< by point
  std::map<std::size_t, int> waits_;        ///< rounds that a point was in use by another process
  std::map<std::size_t, Failure> failures_;
  bool stopping_ = false;
};

}  // namespace bagnold::sweep
