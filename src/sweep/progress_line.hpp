// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// Where a sweep stands, as one line on stdout for all points: rewritten twice a second on a
/// terminal, a plain line every half minute elsewhere. Time left comes from the disk-steps done so
/// far.
class ProgressLine {
 public:
  ProgressLine(Sweep const& sweep, bool quiet);

  void started(std::size_t point);
  void reached(std::size_t point, double share);  ///< of the point's strain
  void was_finished(std::size_t point);           ///< before this process began
  void finished(std::size_t point);
  void stopped(std::size_t point);
  void failed(std::size_t point);

  void show();  ///< if it is time to
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Point {
    double strain = 0;
    double work = 0;    ///< disk-steps
    double first = -1;  ///< share when we first heard of it; -1: not yet
    double share = 0;
    bool given_up = false;
  };
  void print(Clock::time_point now);

  std::vector<Point> points_;
  std::size_t finished_ = 0, running_ = 0, failed_ = 0;
  bool quiet_, terminal_;
  Clock::time_point start_, shown_;
};

}  // namespace bagnold::sweep
