// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/sweep_terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/config/run_time.hpp"
#include "src/run/messages.hpp"
#include "src/sweep/collect.hpp"

namespace bagnold {

SweepTerminal::SweepTerminal(bool quiet) : quiet_(quiet), terminal_(isatty(STDOUT_FILENO) == 1) {}

bool SweepTerminal::stop_requested() { return stop_signal() != 0; }

void SweepTerminal::begin(sweep::Sweep const& sweep) {
  start_ = shown_ = Clock::now();
  finished_ = running_ = failed_ = 0;
  points_.clear();
  for (auto const& point : sweep.points)
    points_.push_back(
        {point.plan.path(point.plan.steps),
         static_cast<double>(point.plan.steps) * static_cast<double>(point.scene.disks.count)});
}

void SweepTerminal::reached(std::size_t point, double share) {
  auto& at = points_[point];
  if (at.first < 0) at.first = share;
  at.share = share;
}

void SweepTerminal::was_finished(std::size_t point) {
  points_[point].first = points_[point].share = 1;
  ++finished_;
}

void SweepTerminal::finished(std::size_t point) {
  points_[point].share = 1;
  --running_;
  ++finished_;
}

void SweepTerminal::failed(std::size_t point) {
  points_[point].given_up = true;
  --running_;
  ++failed_;
}

void SweepTerminal::waited() {
  auto const now = Clock::now();
  auto const pause = terminal_ ? std::chrono::milliseconds(500) : std::chrono::milliseconds(30000);
  if (!quiet_ && now - shown_ >= pause) print(now);
}

void SweepTerminal::end() {
  if (quiet_) return;
  print(Clock::now());
  if (terminal_) put("\n");
}

void SweepTerminal::collected(sweep::Sweep const& sweep, sweep::SweepFolder const& folder,
                              sweep::Results const& results) {
  if (quiet_) return;
  warn(suspect_points(sweep, results, folder.path()));
  if (auto const notes = noted_points(results); !notes.empty()) say("note: " + notes);
  fmt::print("table of {} points in {}\n", sweep.points.size(), folder.table().string());
  if (auto const pieces = results.pieces.point.size(); pieces > 0)
    fmt::print("table of {} pieces in {}\n", pieces, (folder.path() / "pieces.csv").string());
}

void SweepTerminal::print(Clock::time_point now) {
  shown_ = now;
  double strain = 0, all_strain = 0, done = 0, left = 0;
  for (auto const& point : points_) {
    strain += point.share * point.strain;
    all_strain += point.strain;
    if (point.first >= 0) done += (point.share - point.first) * point.work;
    if (!point.given_up) left += (1 - point.share) * point.work;
  }
  double const seconds = std::chrono::duration<double>(now - start_).count();
  auto const line = fmt::format(
      "{} of {} points done, {} running, {} failed  strain {:.0f}%  {}", finished_, points_.size(),
      running_, failed_, 100 * strain / all_strain,
      done > 0 && left > 0 ? time_text(seconds * left / done) + " left" : time_text(seconds));
  put(terminal_ ? fmt::format("\r{:<78}", line) : line + "\n");
}

sweep::SweepOptions sweep_options(Machine const& machine, int jobs, SweepTerminal& terminal) {
  return {.program = std::filesystem::read_symlink("/proc/self/exe"),
          .machine = machine,
          .jobs = jobs,
          .monitor = &terminal};
}

}  // namespace bagnold
