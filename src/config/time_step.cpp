// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold {

double paper_time_step(Scene::Disks const& disks) {
  double const q = disks.elasticity;
  if (disks.model == "CD" || disks.model == "CD_rot")
    return q < 0.5 ? std::max(0.01, 0.1 * q) : 0.05;
  return std::min({0.5 / q, 0.1, 0.2 * q});
}

double time_step(Scene const& scene) {
  if (scene.integration.time_step) return *scene.integration.time_step;
  double const paper = paper_time_step(scene.disks), piece = scene.shear.ramp_every;
  if (scene.shear.protocol != "ramp") return paper;
  return piece / std::ceil(piece / paper * (1 - 1e-12));
}

}  // namespace bagnold
