// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Where a run stands, as a line on stdout: rewritten twice a second on a terminal, a plain line
/// every half minute elsewhere. A sweep that started the run is told too.
class Progress {
 public:
  Progress(Scene const& scene, Plan const& plan, std::int64_t first_step, bool quiet);

  void show(std::int64_t step);
  void finish(std::int64_t step);

 private:
  using Clock = std::chrono::steady_clock;
  void report(std::int64_t step) const;
  void print(std::int64_t step, Clock::time_point now);

  double disks_;
  double strain_;
  std::int64_t steps_;
  std::int64_t first_step_;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point shown_;
  Clock::time_point reported_;  ///< to the sweep
};

}  // namespace bagnold
