// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/stability.hpp"

#include <algorithm>
#include <cmath>

#include "src/config/contact_rates.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

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

/// The largest rate of damping that does not grow, times dt.
double largest_rate_borne(std::string_view scheme) { return scheme == two_stage_scheme ? 7 : 2; }

}  // namespace

double second_stage_share(double z) {
  double const exact = z < 1e-3 ? 0.5 - z / 6 : (z + std::expm1(-z)) / (z * z);
  return std::max(1.0 / 7, exact);
}

double contact_spectral_radius(Scene const& scene, std::string_view scheme, double time_step) {
  ContactRates const r(scene);
  double const h = time_step;
  if (scheme == two_stage_scheme)
    return std::max(two_stage_step(r.stiffness, r.normal, h).radius(),
                    std::abs(two_stage_step(0, r.tangential, h).vv));
  return std::max(papers_step(r.stiffness, r.normal, h).radius(),
                  std::abs(papers_step(0, r.tangential, h).vv));
}

double contact_spectral_radius(Scene const& scene, double time_step) {
  return contact_spectral_radius(scene, scheme_of(scene), time_step);
}

double largest_stable_time_step(Scene const& scene, std::string_view scheme) {
  constexpr double contacts = 6;
  ContactRates const r(scene);
  double const rate = contacts * std::max(r.normal, r.tangential);
  double const damped = largest_rate_borne(scheme) / rate;
  if (scheme == two_stage_scheme) return std::min(damped, 2 / std::sqrt(contacts * r.stiffness));
  double low = 0, high = damped;
  if (contact_spectral_radius(scene, scheme, high) <= 1) return high;
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (contact_spectral_radius(scene, scheme, middle) <= 1 ? low : high) = middle;
  }
  return low;
}

double dense_flow_time_step(Scene const& scene, std::string_view scheme) {
  constexpr double rolling = 18.8, sliding = 8.0, normal = 5.3;  // rates, [k_d / m]
  ContactRates const r(scene);
  double const n = r.normal / 2, t = r.tangential / (scene.rotates() ? 6 : 2);  // k_n/m, k_t/m
  double const rate = scene.disks.model == "CD_n" ? normal * n
                      : scene.disks.model == "CD" ? sliding * n
                                                  : rolling * t + normal * std::max(0.0, n - t);
  return largest_rate_borne(scheme) / rate;
}

}  // namespace bagnold
