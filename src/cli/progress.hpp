// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Progress of a run as a line on stdout: rewritten twice a second on a terminal, a plain line
/// every half minute elsewhere. Steps count all replicas together. It is also reported to a sweep
/// that started the run.
class Progress {
 public:
  /// What is shown here of all work that is reported.
  struct Part {
    double before = 0, share = 1;
  };

  Progress(Scene const& scene, Plan const& plan, std::int64_t first_steps, bool quiet,
           Part const& part);

  void show(std::int64_t steps);
  void finish(std::int64_t steps);

 private:
  using Clock = std::chrono::steady_clock;
  void report(std::int64_t steps) const;
  void print(std::int64_t steps, Clock::time_point now);

  double disks_;
  std::string name_;  ///< of what grows: strain or time
  double whole_;
  std::int64_t steps_;
  std::int64_t first_steps_;
  Part part_;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point shown_;
  Clock::time_point reported_;  ///< to the sweep
};

}  // namespace bagnold
