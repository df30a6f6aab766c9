// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "src/config/run_time.hpp"

namespace bagnold::sweep {

ProgressLine::ProgressLine(Sweep const& sweep, bool quiet)
    : quiet_(quiet), terminal_(isatty(STDOUT_FILENO) == 1), start_(Clock::now()), shown_(start_) {
  for (auto const& point : sweep.points)
    points_.push_back(
        {point.plan.strain(point.plan.steps),
         static_cast<double>(point.plan.steps) * static_cast<double>(point.scene.disks.count)});
}

void ProgressLine::started(std::size_t) { ++running_; }

void ProgressLine::reached(std::size_t point, double share) {
  auto& at = points_[point];
  if (at.first < 0) at.first = share;
  at.share = share;
}

void ProgressLine::was_finished(std::size_t point) {
  points_[point].first = points_[point].share = 1;
  ++finished_;
}

void ProgressLine::finished(std::size_t point) {
  points_[point].share = 1;
  --running_;
  ++finished_;
}

void ProgressLine::stopped(std::size_t) { --running_; }

void ProgressLine::failed(std::size_t point) {
  points_[point].given_up = true;
  --running_;
  ++failed_;
}

void ProgressLine::show() {
  auto const now = Clock::now();
  auto const pause = terminal_ ? std::chrono::milliseconds(500) : std::chrono::milliseconds(30000);
  if (!quiet_ && now - shown_ >= pause) print(now);
}

void ProgressLine::end() {
  if (quiet_) return;
  print(Clock::now());
  if (terminal_) std::fputc('\n', stdout);
}

void ProgressLine::print(Clock::time_point now) {
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
  std::fputs((terminal_ ? fmt::format("\r{:<78}", line) : line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace bagnold::sweep
