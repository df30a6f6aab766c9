// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bagnold {

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
  if (scene.integration.time_step) return *scene.integration.time_step;
  double const rule = scene.integration.scheme == "two-stage-leapfrog"
                          ? two_stage_time_step(scene)
                          : paper_time_step(scene.disks);
  double const piece = scene.shear.ramp_every;
  if (scene.shear.protocol != "ramp") return rule;
  return piece / std::ceil(piece / rule * (1 - 1e-12));
}

namespace {

/// Spectral radius of one step of P2 Eqs. (21)-(24) for x'' = -k x - c x': with f_0 = -k x - c v,
///     x~ = x + h v,  v~ = v + h f_0,  f~ = -k x~ - c v~,
///     v_1 = v + (f_0 + f~) h/2,  x_1 = x + (v + v_1) h/2,
/// a matrix on (x, v).
double oscillator_radius(double k, double c, double h) {
  double const v_of_x = -h * k + h * h / 2 * c * k;
  double const v_of_v = 1 - h * c - h * h / 2 * (k - c * c);
  double const x_of_x = 1 + h / 2 * v_of_x;
  double const x_of_v = h / 2 * (1 + v_of_v);
  double const half_trace = (x_of_x + v_of_v) / 2;
  double const determinant = x_of_x * v_of_v - x_of_v * v_of_x;
  double const discriminant = half_trace * half_trace - determinant;
  if (discriminant < 0) return std::sqrt(determinant);
  return std::abs(half_trace) + std::sqrt(discriminant);
}

}  // namespace

double contact_spectral_radius(Scene const& scene, double time_step) {
  auto const& disks = scene.disks;
  double const mass = scene.mass_by_area() ? std::numbers::pi / 2 : 1.0;
  double const inverse = 2 / mass;
  double const largest_overlap = 0.2;
  double const stiffness =
      (disks.force_exponent - 1) * std::pow(largest_overlap, disks.force_exponent - 2);
  bool const general = disks.model == "general";
  double const normal = (general ? disks.damping_normal : 1.0) / disks.elasticity;
  double const tangential = general                  ? disks.damping_tangential / disks.elasticity
                            : disks.model == "CD_n" ? 0.0
                                                     : 1.0 / disks.elasticity;
  double const rolling = scene.rotates() ? 3.0 : 1.0;

  double const normal_radius = oscillator_radius(stiffness * inverse, normal * inverse, time_step);
  double const z = time_step * tangential * inverse * rolling;
  double const tangential_radius = std::abs(1 - z + z * z / 2);
  return std::max(normal_radius, tangential_radius);
}

}  // namespace bagnold
