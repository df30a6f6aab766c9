// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/run_time.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bagnold {

namespace {

/// Steps of a disk per second on one core: what the default engine did in a dense state, and in a
/// dilute one at a rate of 1e-4 (docs/performance.md).
constexpr double fast_disk_steps = 300e6, slow_disk_steps = 45e6;

}  // namespace

RunTime& RunTime::operator+=(RunTime const& other) {
  expected += other.expected;
  least += other.least;
  most += other.most;
  return *this;
}

double disk_steps(Scene const& scene, Plan const& plan) {
  return static_cast<double>(plan.steps) *
         static_cast<double>(scene.disks.count * scene.disks.replicas);
}

RunTime time_by_steps(Scene const& scene, Plan const& plan) {
  double const all = disk_steps(scene, plan);
  return {all / std::sqrt(fast_disk_steps * slow_disk_steps), all / fast_disk_steps,
          all / slow_disk_steps};
}

std::string time_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.2g} s", seconds);
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

}  // namespace bagnold
