// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Size of the trajectories of a run, all replicas together.
struct TrajectorySize {
  double frames = 0;  ///< of each replica, the first state included
  double bytes = 0;   ///< of the files; twice that while parts are joined
};

/// Size by the plan of a run that writes frames (plan.trajectory_steps > 0).
TrajectorySize trajectory_size(Scene const& scene, Plan const& plan);

}  // namespace bagnold
