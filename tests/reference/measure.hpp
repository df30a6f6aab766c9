// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "tests/reference/system.hpp"

namespace bagnold::reference {

/// What one configuration gives. Tensors [m / tau_e^2], energies [m d_s^2 / tau_e^2].
struct Sums {
  double el[2][2] = {};         ///< (1/L^2) sum_(i<j) f^el_a r_b      P1 Eq. (9), P2 Eq. (12)
  double dis[2][2] = {};        ///< (1/L^2) sum_(i<j) f^dis_a r_b     P1 Eq. (10), P2 Eq. (13)
  double kin[2][2] = {};        ///< (1/L^2) sum_i m_i dv_a dv_b       P1 Eq. (11), P2 Eq. (14)
  long contacts = 0;            ///< pairs; Z = 2 contacts / N
  double kinetic_energy = 0.0;  ///< 1/2 sum m dv^2 + 1/2 sum I thetadot^2
  double elastic_energy = 0.0;  ///< sum of V_ij
  double dissipation = 0.0;     ///< -sum f^dis . v (v^C where disks rotate), per tau_e, >= 0
  double dvx2 = 0.0;            ///< (1/N) sum dv_x^2, P2 Eq. (35)
  double vy2 = 0.0;             ///< (1/N) sum v_y^2, P2 Eq. (36)
  double spin_mean = 0.0;       ///< (1/N) sum thetadot/gammadot; 0 without spins, NaN at rest
  double spin2_mean = 0.0;      ///< (1/N) sum (thetadot/gammadot)^2, P2 Eq. (29)
};

/// dv = v - gammadot y x^, with y as it is stored. Energy obeys
///
///     d(kinetic + elastic)/dt = sigma gammadot L^2 - dissipation,  sigma = -(el + dis + kin)_xy
///
/// (differentiate; the spins enter with their lab value). Only f_x r_y does this in model CD.
inline Sums measure(System const& system) {
  Parameters const& p = system.p;
  State const& s = system.s;
  Sums sums;
  double const area = s.box_length * s.box_height();
  for (Contact const& c : contacts(system)) {
    PairForce const f = pair_force(p, s, c);
    double const r[2] = {c.x, c.y};
    double const elastic[2] = {f.elastic_x, f.elastic_y};
    double const dissipative[2] = {f.dissipative_x, f.dissipative_y};
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) {
        sums.el[a][b] += elastic[a] * r[b] / area;
        sums.dis[a][b] += dissipative[a] * r[b] / area;
      }
    }
    sums.contacts += 1;
    sums.elastic_energy += f.elastic_energy;
    sums.dissipation += f.dissipation;
  }
  double const N = static_cast<double>(s.count());
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const m = mass(p, s.diameter[i]);
    double const dv[2] = {s.velocity[i][0] - p.strain_rate * s.position[i][1], s.velocity[i][1]};
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) sums.kin[a][b] += m * dv[a] * dv[b] / area;
    }
    sums.kinetic_energy += 0.5 * m * (dv[0] * dv[0] + dv[1] * dv[1]);
    sums.dvx2 += dv[0] * dv[0] / N;
    sums.vy2 += dv[1] * dv[1] / N;
    if (rotates(p)) {
      double const inertia = moment_of_inertia(p, s.diameter[i]);
      double const ratio = p.strain_rate != 0.0 ? s.spin[i] / p.strain_rate
                                                : std::numeric_limits<double>::quiet_NaN();
      sums.kinetic_energy += 0.5 * inertia * s.spin[i] * s.spin[i];
      sums.spin_mean += ratio / N;
      sums.spin2_mean += ratio * ratio / N;
    }
  }
  return sums;
}

}  // namespace bagnold::reference
