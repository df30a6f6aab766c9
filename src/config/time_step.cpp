// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <cmath>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/laws.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

double rule_time_step(Scene const& scene, std::string_view scheme) {
  return law_of(scene.disks).rule_time_step(scheme, scene.disks);
}

std::string_view scheme_of(Scene const& scene) {
  auto const& given = scene.integration.scheme;
  return given == automatic ? DefaultScheme::name : std::string_view(given);
}

double paper_time_step(Scene::Disks const& disks) {
  return law_of(disks).paper_time_step(disks.elasticity);
}

double time_step(Scene const& scene) {
  auto const& given = scene.integration.time_step;
  if (given.number) return *given.number;
  double const rule = given.word == of_papers ? paper_time_step(scene.disks)
                                              : rule_time_step(scene, scheme_of(scene));
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
