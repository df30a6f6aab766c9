// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "src/cli/standard_streams.hpp"
#include "src/config/run_time.hpp"
#include "src/sweep/report.hpp"

namespace bagnold {

Progress::Progress(Scene const& scene, Plan const& plan, std::int64_t first_steps, bool quiet,
                   Part const& part)
    : disks_(static_cast<double>(scene.disks.count)),
      name_(plan.progress_name()),
      whole_(plan.progress(plan.steps)),
      steps_(plan.steps * scene.disks.replicas),
      first_steps_(first_steps),
      part_(part),
      quiet_(quiet),
      terminal_(isatty(STDOUT_FILENO) == 1),
      start_(Clock::now()),
      shown_(start_),
      reported_(start_) {
  report(first_steps);
}

void Progress::show(std::int64_t steps) {
  auto const now = Clock::now();
  if (now - reported_ >= std::chrono::milliseconds(500)) {
    report(steps);
    reported_ = now;
  }
  if (quiet_ || now - shown_ <
                    (terminal_ ? std::chrono::milliseconds(500) : std::chrono::milliseconds(30000)))
    return;
  print(steps, now);
}

void Progress::finish(std::int64_t steps) {
  if (quiet_) return;
  print(steps, Clock::now());
  if (terminal_) put("\n");
}

void Progress::report(std::int64_t steps) const {
  double const share = static_cast<double>(steps) / static_cast<double>(steps_);
  sweep::report_share(part_.before + part_.share * share);
}

void Progress::print(std::int64_t steps, Clock::time_point now) {
  shown_ = now;
  double const seconds = std::chrono::duration<double>(now - start_).count();
  double const done = static_cast<double>(steps - first_steps_);
  double const share = static_cast<double>(steps) / static_cast<double>(steps_);
  double const left = done > 0 ? seconds / done * static_cast<double>(steps_ - steps) : 0;
  auto const line =
      fmt::format("{} {:.4g} of {:.4g} ({:.0f}%)  {:.3g} million disk-steps/s  {}", name_,
                  share * whole_, whole_, 100 * share, done * disks_ / seconds / 1e6,
                  steps < steps_ ? time_text(left) + " left" : time_text(seconds));
  put(terminal_ ? fmt::format("\r{:<78}", line) : line + "\n");
}

}  // namespace bagnold
