// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/reference/system.hpp"

namespace bagnold::reference {

/// The equations of a step of backward Euler, all pairs and images, positions and forces at its
/// end:
///
///     R(u) = M (u - v) - h F(r + h u, u) = 0
///
/// Elastic forces of disks in contact there. Damping along the normal with the share of the way
/// from the old to the new distance that lies within contact; along the tangent where the disks
/// were in contact at the beginning.
struct EulerStep {
  Parameters const& p;
  State const& s;        ///< where the step begins
  double offset_before;  ///< gamma L_y there, [d_s]
  double offset_after;   ///< and where it ends

  /// What a step's pairs add up to, and what is left of the equations.
  struct Result {
    std::vector<double> left;                           ///< R: {x, y, torque} of each disk
    double elastic[2][2] = {}, dissipative[2][2] = {};  ///< sum f_a r_b, [m d_s^2 / tau_e^2]
    double dissipation = 0, torque_power = 0;
    long contacts = 0;
  };

  Result operator()(std::vector<double> const& u) const {
    Result result;
    double const h = p.time_step, k_d = 1 / p.elasticity;
    bool const both = p.model == Parameters::Model::CD_nt;
    double const k_n = k_d * (both ? p.damping_normal : 1);
    double const k_t =
        p.model == Parameters::Model::CD_n ? 0 : k_d * (both ? p.damping_tangential : 1);
    std::size_t const n = s.count();
    result.left.assign(3 * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      double const m = mass(p, s.diameter[i]);
      result.left[3 * i] = m * (u[3 * i] - s.velocity[i][0]);
      result.left[3 * i + 1] = m * (u[3 * i + 1] - s.velocity[i][1]);
      if (rotates(p))
        result.left[3 * i + 2] = moment_of_inertia(p, s.diameter[i]) * (u[3 * i + 2] - s.spin[i]);
    }
    double const width = s.box_length, height = s.box_height();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (int b = -2; b <= 2; ++b)
          for (int a = -4; a <= 4; ++a) {
            double const d_i = s.diameter[i], d_j = s.diameter[j], d = (d_i + d_j) / 2;
            double const x0 = s.position[i][0] - s.position[j][0] - a * width - b * offset_before;
            double const y0 = s.position[i][1] - s.position[j][1] - b * height;
            double const ux = u[3 * i] - u[3 * j], uy = u[3 * i + 1] - u[3 * j + 1];
            double const x1 = x0 + h * ux - b * (offset_after - offset_before);
            double const y1 = y0 + h * uy;
            double const before = d - std::hypot(x0, y0), after = d - std::hypot(x1, y1);
            if (before <= 0 && after <= 0) continue;
            double share = 1;
            if (before <= 0) share = after / (after - before);
            if (after <= 0) share = before / (before - after);
            double const r = d - after, nx = x1 / r, ny = y1 / r;
            double vx = ux - b * p.strain_rate * height, vy = uy;
            if (rotates(p)) {  // the points of contact lie at -r d_i/(d_i + d_j) and +r d_j/(..)
              double const turn = (d_i * u[3 * i + 2] + d_j * u[3 * j + 2]) / (d_i + d_j);
              vx += turn * y1;
              vy -= turn * x1;
            }
            double const v_n = vx * nx + vy * ny;
            double const tangential = before > 0 ? k_t : 0;
            double const elastic = after > 0 ? after / (d * d) : 0;
            double const f[2] = {-k_n * share * v_n * nx - tangential * (vx - v_n * nx),
                                 -k_n * share * v_n * ny - tangential * (vy - v_n * ny)};
            double const e[2] = {elastic * nx, elastic * ny}, r1[2] = {x1, y1};
            for (int c = 0; c < 2; ++c) {
              result.left[3 * i + c] -= h * (e[c] + f[c]);
              result.left[3 * j + c] += h * (e[c] + f[c]);
              for (int k = 0; k < 2; ++k) {
                result.elastic[c][k] += e[c] * r1[k];
                result.dissipative[c][k] += f[c] * r1[k];
              }
            }
            result.dissipation -= f[0] * vx + f[1] * vy;
            if (after > 0) ++result.contacts;
            if (!rotates(p)) continue;
            double const torque = -(x1 * f[1] - y1 * f[0]) / (d_i + d_j);
            result.left[3 * i + 2] -= h * d_i * torque;
            result.left[3 * j + 2] -= h * d_j * torque;
            result.torque_power += torque * (d_i * u[3 * i + 2] + d_j * u[3 * j + 2]);
          }
    return result;
  }
};

/// Gauss' elimination with pivots; a: n x n by rows.
inline std::vector<double> solve_dense(std::vector<double> a, std::vector<double> b) {
  std::size_t const n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i * n + k]) > std::abs(a[pivot * n + k])) pivot = i;
    for (std::size_t c = 0; c < n; ++c) std::swap(a[k * n + c], a[pivot * n + c]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      double const share = a[i * n + k] / a[k * n + k];
      for (std::size_t c = k; c < n; ++c) a[i * n + c] -= share * a[k * n + c];
      b[i] -= share * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c) b[k] -= a[k * n + c] * b[c];
    b[k] /= a[k * n + k];
  }
  return b;
}

/// One step of backward Euler by Newton's iterations with a matrix of differences, halved until
/// they lead down; to `tolerance` of the first |R|. Throws where they end elsewhere.
inline EulerStep::Result backward_euler_step(System& system, double tolerance) {
  Parameters const& p = system.p;
  State& s = system.s;
  double const height = s.box_height();
  double const before = reduced_offset(strain(system), s);
  EulerStep const equations{p, s, before, before + p.strain_rate * p.time_step * height};
  std::size_t const n = s.count();
  std::vector<double> u(3 * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    u[3 * i] = s.velocity[i][0];
    u[3 * i + 1] = s.velocity[i][1];
    if (rotates(p)) u[3 * i + 2] = s.spin[i];
  }
  auto const norm = [](std::vector<double> const& of) {
    double sum = 0;
    for (double const one : of) sum += one * one;
    return std::sqrt(sum);
  };
  auto now = equations(u);
  double const first = norm(now.left);
  for (int k = 0; norm(now.left) > tolerance * first; ++k) {
    if (k == 200) throw std::runtime_error("backward_euler_step: Newton does not converge");
    std::vector<double> matrix(9 * n * n, 0.0);
    double const little = 1e-7 * (p.strain_rate == 0 ? 1 : p.strain_rate);
    for (std::size_t c = 0; c < 3 * n; ++c) {
      auto up = u, down = u;
      up[c] += little;
      down[c] -= little;
      auto const high = equations(up).left, low = equations(down).left;
      for (std::size_t r = 0; r < 3 * n; ++r)
        matrix[r * 3 * n + c] = (high[r] - low[r]) / (2 * little);
      if (c % 3 == 2 && !rotates(p)) matrix[c * 3 * n + c] = 1;
    }
    auto const direction = solve_dense(matrix, now.left);
    double share = 1;
    for (int t = 0;; ++t, share /= 2) {
      auto trial = u;
      for (std::size_t c = 0; c < 3 * n; ++c) trial[c] -= share * direction[c];
      auto const there = equations(trial);
      if (norm(there.left) > (1 - 0.1 * share) * norm(now.left) && t < 12) continue;
      u = trial;
      now = there;
      break;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (int c = 0; c < 2; ++c) {
      s.velocity[i][c] = u[3 * i + c];
      s.position[i][c] += p.time_step * u[3 * i + c];
    }
    if (rotates(p)) s.spin[i] = u[3 * i + 2];
  }
  ++system.step;
  wrap(p, s, strain(system));
  s.offset = reduced_offset(strain(system), s);
  s.time = system.initial_time + p.time_step * static_cast<double>(system.step);
  return now;
}

}  // namespace bagnold::reference
