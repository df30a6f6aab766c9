// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bagnold {

namespace {

/// Two small disks in contact: rates and squared frequency, [1/tau_e], [1/tau_e^2].
struct Rates {
  double stiffness, normal, tangential;

  explicit Rates(Scene const& scene) {
    auto const& disks = scene.disks;
    double const mass = scene.mass_by_area() ? std::numbers::pi / 2 : 1.0;
    double const inverse = 2 / mass;
    double const largest_overlap = 0.2;
    stiffness =
        inverse * (disks.force_exponent - 1) * std::pow(largest_overlap, disks.force_exponent - 2);
    bool const general = disks.model == "general";
    double const rolling = scene.rotates() ? 3.0 : 1.0;
    normal = inverse * (general ? disks.damping_normal : 1.0) / disks.elasticity;
    tangential =
        disks.model == "CD_n"
            ? 0.0
            : inverse * rolling * (general ? disks.damping_tangential : 1.0) / disks.elasticity;
  }
};

/// One step on (x, v).
struct Matrix {
  double xx, xv, vx, vv;

  double radius() const {
    double const half_trace = (xx + vv) / 2;
    double const determinant = xx * vv - xv * vx;
    double const discriminant = half_trace * half_trace - determinant;
    if (discriminant < 0) return std::sqrt(determinant);
    return std::abs(half_trace) + std::sqrt(discriminant);
  }
};

/// P2 Eqs. (21)-(24) for x'' = -k x - c x': with f_0 = -k x - c v,
///     x~ = x + h v,  v~ = v + h f_0,  f~ = -k x~ - c v~,
///     v_1 = v + (f_0 + f~) h/2,  x_1 = x + (v + v_1) h/2.
Matrix papers_step(double k, double c, double h) {
  double const vx = -h * k + h * h / 2 * c * k;
  double const vv = 1 - h * c - h * h / 2 * (k - c * c);
  return {1 + h / 2 * vx, h / 2 * (1 + vv), vx, vv};
}

/// v_1 = v + (1 - alpha h c) h f_0,  x_1 = x + h v_1.
Matrix two_stage_step(double k, double c, double h) {
  double const held = 1 - second_stage_share(h * c) * h * c;
  double const vx = -held * h * k, vv = 1 - held * h * c;
  return {1 + h * vx, h * vv, vx, vv};
}

}  // namespace

double second_stage_share(double z) {
  double const exact = z < 1e-3 ? 0.5 - z / 6 : (z + std::expm1(-z)) / (z * z);
  return std::max(1.0 / 7, exact);
}

double contact_spectral_radius(Scene const& scene, std::string_view scheme, double time_step) {
  Rates const r(scene);
  double const h = time_step;
  if (scheme == two_stage_scheme)
    return std::max(two_stage_step(r.stiffness, r.normal, h).radius(),
                    std::abs(two_stage_step(0, r.tangential, h).vv));
  return std::max(papers_step(r.stiffness, r.normal, h).radius(),
                  std::abs(papers_step(0, r.tangential, h).vv));
}

double contact_spectral_radius(Scene const& scene, double time_step) {
  return contact_spectral_radius(scene, scene.integration.scheme, time_step);
}

double largest_stable_time_step(Scene const& scene, std::string_view scheme) {
  constexpr double contacts = 6;
  Rates const r(scene);
  double const rate = contacts * std::max(r.normal, r.tangential);
  if (scheme == two_stage_scheme) return std::min(7 / rate, 2 / std::sqrt(contacts * r.stiffness));
  double low = 0, high = 2 / rate;
  if (contact_spectral_radius(scene, scheme, high) <= 1) return high;
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (contact_spectral_radius(scene, scheme, middle) <= 1 ? low : high) = middle;
  }
  return low;
}

}  // namespace bagnold
