// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Run time on one core, [s]: an estimate and bounds that should hold it.
struct RunTime {
  double expected = 0;
  double least = 0;
  double most = 0;

  RunTime& operator+=(RunTime const& other);
};

/// Disks times steps, of all replicas.
double disk_steps(Scene const& scene, Plan const& plan);

/// Run time by the number of steps alone, if no trial is possible: good to a factor of 7 at rates
/// of 1e-4 and above, too long below in a dilute state.
RunTime time_by_steps(Scene const& scene, Plan const& plan);

/// Seconds as "12 min", "3.5 h".
std::string time_text(double seconds);

}  // namespace bagnold
