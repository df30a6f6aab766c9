// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold {

std::string_view scheme_of(Scene const& scene) {
  auto const& given = scene.integration.scheme;
  return given == automatic ? two_stage_scheme : std::string_view(given);
}

double paper_time_step(Scene::Disks const& disks) {
  double const q = disks.elasticity;
  if (disks.model == "CD" || disks.model == "CD_rot")
    return q < 0.5 ? std::max(0.01, 0.1 * q) : 0.05;
  return std::min({0.5 / q, 0.1, 0.2 * q});
}

double two_stage_time_step(Scene const& scene) {
  auto const& disks = scene.disks;
  double const damping =
      disks.model == "general" ? std::max(disks.damping_normal, disks.damping_tangential) : 1.0;
  return std::min(0.2, (scene.rotates() ? 0.2 : 0.5) * disks.elasticity / damping);
}

double time_step(Scene const& scene) {
  auto const& given = scene.integration.time_step;
  if (given.number) return *given.number;
  bool const papers = given.word == of_papers || scheme_of(scene) == papers_scheme;
  double const rule = papers ? paper_time_step(scene.disks) : two_stage_time_step(scene);
  double const piece = scene.shear.ramp_every;
  if (scene.shear.protocol != "ramp") return rule;
  return piece / std::ceil(piece / rule * (1 - 1e-12));
}

Scene resolved(Scene scene) {
  scene.integration.time_step = time_step(scene);
  scene.integration.scheme = scheme_of(scene);
  return scene;
}

}  // namespace bagnold
