// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "src/sweep/run_sweep.hpp"

namespace bagnold {

/// Shows sweeps to their user, unless quiet, and stops them on their signals: one line on stdout
/// for all points, rewritten twice a second on a terminal, a plain line every half minute
/// elsewhere. Time left comes from the disk-steps done so far.
class SweepTerminal final : public sweep::SweepMonitor {
 public:
  explicit SweepTerminal(bool quiet);

  bool stop_requested() override;
  void begin(sweep::Sweep const& sweep) override;
  void was_finished(std::size_t point) override;
  void started(std::size_t) override { ++running_; }
  void reached(std::size_t point, double share) override;
  void finished(std::size_t point) override;
  void stopped(std::size_t) override { --running_; }
  void failed(std::size_t point) override;
  void waited() override;
  void end() override;

  /// Prints the name of the table and, on stderr, the suspect points.
  void collected(sweep::Sweep const& sweep, sweep::SweepFolder const& folder,
                 sweep::Results const& results) override;

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

/// Points are run by this program, `jobs` at a time (0: as many as the cores take), and shown on
/// the terminal.
sweep::SweepOptions sweep_options(Machine const& machine, int jobs, SweepTerminal& terminal);

}  // namespace bagnold
