// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/reference/parameters.hpp"

namespace bagnold::reference {

/// 1/2 sum I thetadot^2, [m d_s^2 / tau_e^2].
inline double rotation_energy(Parameters const& p, State const& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < s.spin.size(); ++i)
    sum += 0.5 * moment_of_inertia(p, s.diameter[i]) * s.spin[i] * s.spin[i];
  return sum;
}

/// 1/2 sum m v^2 + 1/2 sum I thetadot^2 in the lab frame, [m d_s^2 / tau_e^2].
inline double motion_energy(Parameters const& p, State const& s) {
  double sum = rotation_energy(p, s);
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const vx = s.velocity[i][0], vy = s.velocity[i][1];
    sum += 0.5 * mass(p, s.diameter[i]) * (vx * vx + vy * vy);
  }
  return sum;
}

}  // namespace bagnold::reference
