// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/trajectory_size.hpp"

namespace bagnold {

TrajectorySize trajectory_size(Scene const& scene, Plan const& plan) {
  constexpr double numbers = 8.5;  // a disk and frame: seven doubles, three integers of 32 bits
  double const frames =
      1 + static_cast<double>(plan.steps) / static_cast<double>(plan.trajectory_steps);
  double const disks = static_cast<double>(scene.disks.count * scene.disks.replicas);
  return {frames, frames * numbers * sizeof(double) * disks};
}

}  // namespace bagnold
