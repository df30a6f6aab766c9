// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace bagnold {

namespace {

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

}  // namespace

Progress::Progress(Scene const& scene, Plan const& plan, std::int64_t first_steps, bool quiet)
    : disks_(static_cast<double>(scene.disks.count)),
      strain_(plan.time_step * scene.shear.strain_rate * static_cast<double>(plan.steps)),
      steps_(plan.steps * scene.disks.replicas),
      first_steps_(first_steps),
      quiet_(quiet),
      terminal_(isatty(STDOUT_FILENO) == 1),
      start_(Clock::now()),
      shown_(start_) {}

void Progress::show(std::int64_t steps) {
  auto const now = Clock::now();
  if (quiet_ || now - shown_ <
                    (terminal_ ? std::chrono::milliseconds(500) : std::chrono::milliseconds(30000)))
    return;
  print(steps, now);
}

void Progress::finish(std::int64_t steps) {
  if (quiet_) return;
  print(steps, Clock::now());
  if (terminal_) std::fputc('\n', stdout);
}

void Progress::print(std::int64_t steps, Clock::time_point now) {
  shown_ = now;
  double const seconds = std::chrono::duration<double>(now - start_).count();
  double const done = static_cast<double>(steps - first_steps_);
  double const share = static_cast<double>(steps) / static_cast<double>(steps_);
  double const left = done > 0 ? seconds / done * static_cast<double>(steps_ - steps) : 0;
  auto const line =
      fmt::format("strain {:.4g} of {:.4g} ({:.0f}%)  {:.3g} million disk-steps/s  {}",
                  share * strain_, strain_, 100 * share, done * disks_ / seconds / 1e6,
                  steps < steps_ ? duration(left) + " left" : duration(seconds));
  if (terminal_)
    fmt::print("\r{:<78}", line);
  else
    fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace bagnold
