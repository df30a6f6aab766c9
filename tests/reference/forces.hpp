// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "tests/reference/contacts.hpp"

namespace bagnold::reference {

/// What one contact does: forces on i from j, torques on both, all taken from one formula sheet.
struct PairForce {
  double elastic_x, elastic_y;          ///< f_ij^el, [m d_s / tau_e^2]
  double dissipative_x, dissipative_y;  ///< f_ij^dis, same unit
  double torque_i, torque_j;            ///< about the centres, counter-clockwise
  double elastic_energy;                ///< V_ij, [m d_s^2 / tau_e^2]
  double dissipation;  ///< -f_dis . v, v the velocity difference that the law damps, >= 0
};

/// Elastic part: P1 and P2 Eqs. (1), (2). Dissipative part, with n = r_ij / r_ij, v = v_i - v_j and
/// v^C = v_i^Cj - v_j^Ci of P2 Eq. (6):
///
///     CD       -k_d v                                          P2 Eq. (3)
///     CD_n     -k_d (v . n) n                                  P1 Eq. (3)
///     CD_rot   -k_d v^C                                        P2 Eq. (5)
///     CD_nt    -k_d^n (v^C . n) n - k_d^t [v^C - (v^C . n) n]  P2, below Eq. (7)
///
/// Torques, P2 Eq. (7): tau_i = s_ji x f_ij and tau_j = s_ij x f_ji, s_ji = r_ji d_i / (d_i + d_j).
inline PairForce pair_force(Parameters const& p, State const& s, Contact const& c) {
  PairForce f{};
  double const nx = c.x / c.separation;
  double const ny = c.y / c.separation;
  double const overlap = 1.0 - c.separation / c.contact_distance;
  double const elastic = std::pow(overlap, p.force_exponent - 1.0) / c.contact_distance;
  f.elastic_x = elastic * nx;
  f.elastic_y = elastic * ny;
  f.elastic_energy = std::pow(overlap, p.force_exponent) / p.force_exponent;

  double vx = c.velocity_x;
  double vy = c.velocity_y;
  double const d_i = s.diameter[c.i];
  double const d_j = s.diameter[c.j];
  double const arm_i_x = -c.x * d_i / (d_i + d_j);  // s_ji, from centre i to the point of contact
  double const arm_i_y = -c.y * d_i / (d_i + d_j);
  double const arm_j_x = c.x * d_j / (d_i + d_j);  // s_ij, from centre j to the same point
  double const arm_j_y = c.y * d_j / (d_i + d_j);
  if (rotates(p)) {  // v^C: z x s = (-s_y, s_x)
    vx += -s.spin[c.i] * arm_i_y + s.spin[c.j] * arm_j_y;
    vy += s.spin[c.i] * arm_i_x - s.spin[c.j] * arm_j_x;
  }

  double const k_d = 1.0 / p.elasticity;
  double const v_n = vx * nx + vy * ny;
  switch (p.model) {
    case Parameters::Model::CD:
    case Parameters::Model::CD_rot:
      f.dissipative_x = -k_d * vx;
      f.dissipative_y = -k_d * vy;
      break;
    case Parameters::Model::CD_n:
      f.dissipative_x = -k_d * v_n * nx;
      f.dissipative_y = -k_d * v_n * ny;
      break;
    case Parameters::Model::CD_nt: {
      double const k_n = p.damping_normal * k_d;
      double const k_t = p.damping_tangential * k_d;
      f.dissipative_x = -k_n * v_n * nx - k_t * (vx - v_n * nx);
      f.dissipative_y = -k_n * v_n * ny - k_t * (vy - v_n * ny);
      break;
    }
  }
  if (rotates(p)) {
    f.torque_i = arm_i_x * f.dissipative_y - arm_i_y * f.dissipative_x;
    f.torque_j = -(arm_j_x * f.dissipative_y - arm_j_y * f.dissipative_x);  // f_ji = -f_ij
  }
  f.dissipation = -(f.dissipative_x * vx + f.dissipative_y * vy);
  return f;
}

/// Per disk: f_x, f_y [m d_s / tau_e^2] and torque [m d_s^2 / tau_e^2] (0 without spins), for the
/// given configuration at the given strain (s.offset is not read).
inline std::vector<std::array<double, 3>> forces_and_torques(Parameters const& p, State const& s,
                                                             double strain) {
  std::vector<std::array<double, 3>> total(s.count(), {0.0, 0.0, 0.0});
  for (Contact const& c : contacts(p, s, strain)) {
    PairForce const f = pair_force(p, s, c);
    total[c.i][0] += f.elastic_x + f.dissipative_x;
    total[c.i][1] += f.elastic_y + f.dissipative_y;
    total[c.i][2] += f.torque_i;
    total[c.j][0] -= f.elastic_x + f.dissipative_x;
    total[c.j][1] -= f.elastic_y + f.dissipative_y;
    total[c.j][2] += f.torque_j;
  }
  return total;
}

}  // namespace bagnold::reference
