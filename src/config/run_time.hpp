// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Bounds of what a run may take on one core, [s]: an estimate only.
struct RunTime {
  double least = 0;
  double most = 0;
};

RunTime estimated_time(Scene const& scene, Plan const& plan);

/// Seconds as "12 min", "3.5 h".
std::string time_text(double seconds);

}  // namespace bagnold
