// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/physics/drives/drive.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/laws.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

double rule_time_step(Scene const& scene, std::string_view scheme) {
  return law_of(scene.disks).rule_time_step(scheme, scene.disks);
}

double drag_rate(Scene const& scene) {
  auto const table = make_species_table(scene.mass_by_area());
  double const drag = scene.drive.drag, of_motion = drag * table.inverse_mass[0];
  double const of_spin = spin_drag(drag, table.diameter[0]) * table.inverse_inertia[0];
  return scene.rotates() ? std::max(of_motion, of_spin) : of_motion;
}

std::string_view scheme_of(Scene const& scene) {
  auto const& given = scene.integration.scheme;
  return given == automatic ? DefaultScheme::name : std::string_view(given);
}

double paper_time_step(Scene::Disks const& disks) {
  return law_of(disks).paper_time_step(disks.elasticity);
}

namespace {

/// Up to which a drag acts on a disk alone as in continuous time, within a percent even with the
/// papers' scheme: a fifth of the shortest relaxation time, that of small disks, [tau_e].
double drag_time_step(Scene const& scene) {
  double const rate = drag_rate(scene);
  return rate > 0 ? 0.2 / rate : std::numeric_limits<double>::infinity();
}

}  // namespace

double time_step(Scene const& scene) {
  auto const& given = scene.integration.time_step;
  if (given.number) return *given.number;
  double const rule = given.word == of_papers ? paper_time_step(scene.disks)
                                              : std::min(rule_time_step(scene, scheme_of(scene)),
                                                         drag_time_step(scene));
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
