// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/reference/forces.hpp"

namespace bagnold::reference {

/// A state under way. Time and strain follow from the integer step count, so that they do not
/// drift.
struct System {
  Parameters p;
  State s;  ///< positions in the box, lab-frame velocities; offset and time kept up to date
  long step = 0;
  double initial_strain = 0.0;  ///< at step 0
  double initial_time = 0.0;    ///< at step 0, [tau_e]

  /// Starts at the strain of s.offset. Spins are added at rest, or dropped, as the law wants.
  System(Parameters const& parameters, State state) : p(parameters), s(std::move(state)) {
    initial_strain = s.offset / s.box_height();
    initial_time = s.time;
    if (!rotates(p)) s.spin.clear();
    if (rotates(p) && s.spin.empty()) s.spin.assign(s.count(), 0.0);
  }
};

/// gamma = gamma_0 + gammadot t, `steps_ahead` steps from now.
inline double strain(System const& system, long steps_ahead = 0) {
  return system.initial_strain +
         system.p.strain_rate * system.p.time_step * static_cast<double>(system.step + steps_ahead);
}

/// Puts in place of each disk its image in the box: a crossing of y = L_y takes gamma L_y off x and
/// gammadot L_y off v_x, besides L_y off y.
inline void wrap(Parameters const& p, State& s, double strain) {
  double const width = s.box_length, height = s.box_height();
  double const offset = reduced_offset(strain, s);
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const n = std::floor(s.position[i][1] / height);
    s.position[i][1] -= n * height;
    s.position[i][0] -= n * offset;
    s.velocity[i][0] -= n * p.strain_rate * height;
    s.position[i][0] -= std::floor(s.position[i][0] / width) * width;
  }
}

/// zeta_r, torque over spin: a sphere's, zeta d^2/3.
inline double spin_drag(Parameters const& p, double diameter) {
  return p.drag * diameter * diameter / 3.0;
}

/// Adds what acts on each disk alone: -zeta [v - u(r)], u = gammadot y x^, and on the spin
/// -zeta_r (thetadot + gammadot/2), where u turns by -gammadot/2; and the push of the step.
inline void add_drive(System const& system, State const& s,
                      std::vector<std::array<double, 3>>& forces) {
  Parameters const& p = system.p;
  for (std::size_t i = 0; i < s.count(); ++i) {
    forces[i][0] -= p.drag * (s.velocity[i][0] - p.strain_rate * s.position[i][1]);
    forces[i][1] -= p.drag * s.velocity[i][1];
    if (rotates(p)) forces[i][2] -= spin_drag(p, s.diameter[i]) * (s.spin[i] + p.strain_rate / 2.0);
    if (!p.push) continue;
    auto const push = p.push(i, system.step);
    for (int a = 0; a < 3; ++a) forces[i][a] += push[a];
  }
}

/// One step of the modified velocity Verlet scheme, P2 Eqs. (21)-(24), and the equivalent of Eqs.
/// (21) and (23) for the spins. The trial state belongs to t + dt, and so does its strain.
inline void step(System& system) {
  Parameters const& p = system.p;
  double const dt = p.time_step;
  State const before = system.s;
  State trial = before;
  State& after = system.s;
  auto f0 = forces_and_torques(p, before, strain(system));
  add_drive(system, before, f0);
  for (std::size_t i = 0; i < before.count(); ++i) {
    double const m = mass(p, before.diameter[i]);
    for (int a = 0; a < 2; ++a) {
      trial.velocity[i][a] = before.velocity[i][a] + f0[i][a] * dt / m;           // (21)
      trial.position[i][a] = before.position[i][a] + before.velocity[i][a] * dt;  // (22)
    }
    if (rotates(p)) {
      double const inertia = moment_of_inertia(p, before.diameter[i]);
      trial.spin[i] = before.spin[i] + f0[i][2] * dt / inertia;
    }
  }
  auto f1 = forces_and_torques(p, trial, strain(system, 1));
  add_drive(system, trial, f1);
  for (std::size_t i = 0; i < before.count(); ++i) {
    double const m = mass(p, before.diameter[i]);
    for (int a = 0; a < 2; ++a) {
      after.velocity[i][a] =
          before.velocity[i][a] + (f0[i][a] + f1[i][a]) * dt / (2.0 * m);  // (23)
      after.position[i][a] = before.position[i][a] +
                             (before.velocity[i][a] + after.velocity[i][a]) * dt / 2.0;  // (24)
    }
    if (rotates(p)) {
      double const inertia = moment_of_inertia(p, before.diameter[i]);
      after.spin[i] = before.spin[i] + (f0[i][2] + f1[i][2]) * dt / (2.0 * inertia);
    }
  }
  ++system.step;
  wrap(p, after, strain(system));
  after.offset = reduced_offset(strain(system), after);
  after.time = system.initial_time + dt * static_cast<double>(system.step);
}

inline std::vector<Contact> contacts(System const& system) {
  return contacts(system.p, system.s, strain(system));
}

inline double largest_overlap(System const& system) {
  return largest_overlap(system.p, system.s, strain(system));
}

}  // namespace bagnold::reference
