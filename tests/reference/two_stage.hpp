// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "tests/reference/system.hpp"

namespace bagnold::reference {

/// alpha(z) = max{1/7, (z - 1 + e^-z)/z^2}, as a series where the difference cancels.
inline double second_share(double z) {
  double sum = 0.0, term = 0.5;  // sum of (-z)^k / (k + 2)!
  if (z > 1.0) return std::max((z - 1.0 + std::exp(-z)) / (z * z), 1.0 / 7.0);
  for (int k = 0; k < 30; ++k) {
    sum += term;
    term *= -z / (k + 3);
  }
  return std::max(sum, 1.0 / 7.0);
}

/// The law with its damping times alpha(z), z = N k dt (1/m_i + 1/m_j), along the normal and,
/// threefold for disks that roll, along the tangent; N from the disk with more contacts.
inline Parameters second_law(Parameters p, State const& s, Contact const& c, int most) {
  double const z = most * p.time_step / p.elasticity *
                   (1.0 / mass(p, s.diameter[c.i]) + 1.0 / mass(p, s.diameter[c.j]));
  if (!rotates(p)) {
    p.elasticity /= second_share(z);
    return p;
  }
  if (p.model == Parameters::Model::CD_rot) p.damping_normal = p.damping_tangential = 1.0;
  p.model = Parameters::Model::CD_nt;
  p.damping_normal *= second_share(p.damping_normal * z);
  p.damping_tangential *= second_share(3.0 * p.damping_tangential * z);
  return p;
}

/// The velocity difference that the law damps: minus its force at unit damping.
inline std::array<double, 2> damped_velocity(Parameters p, State const& s, Contact const& c) {
  p.elasticity = 1.0;
  if (rotates(p)) {
    p.model = Parameters::Model::CD_nt;
    p.damping_normal = p.damping_tangential = 1.0;
  }
  PairForce const f = pair_force(p, s, c);
  return {-f.dissipative_x, -f.dissipative_y};
}

/// What the damping of a step does, [m d_s^2 / tau_e^3].
struct StepPower {
  double dissipation = 0.0;  ///< -sum f . v over pairs, v halfway through the step
  double torque = 0.0;       ///< that the rotation gains
};

/// One step of the two-stage leapfrog: all forces with the velocities of half a step before, then
/// the damping of the changes that they make, drag included, then positions. dissipative: out, sum
/// f_a r_b of both.
inline StepPower two_stage_step(System& system, double (&dissipative)[2][2]) {
  Parameters const& p = system.p;
  State& s = system.s;
  double const dt = p.time_step;
  auto const found = contacts(system);
  State change = s;
  for (auto& v : change.velocity) v = {0.0, 0.0};
  for (auto& spin : change.spin) spin = 0.0;
  State all = change;
  std::vector<int> count(s.count(), 0);
  for (auto& row : dissipative) row[0] = row[1] = 0.0;
  auto const exert = [&](Contact const& c, double x, double y, PairForce const& f, State& on) {
    for (auto const& [disk, sign, torque] :
         {std::tuple{c.i, 1.0, f.torque_i}, std::tuple{c.j, -1.0, f.torque_j}}) {
      double const m = mass(p, s.diameter[disk]);
      on.velocity[disk][0] += sign * x * dt / m;
      on.velocity[disk][1] += sign * y * dt / m;
      if (rotates(p)) on.spin[disk] += torque * dt / moment_of_inertia(p, s.diameter[disk]);
    }
    double const force[2] = {f.dissipative_x, f.dissipative_y}, r[2] = {c.x, c.y};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) dissipative[a][b] += force[a] * r[b];
  };
  auto const changed = [](Contact c, State const& by) {
    c.velocity_x = by.velocity[c.i][0] - by.velocity[c.j][0];
    c.velocity_y = by.velocity[c.i][1] - by.velocity[c.j][1];
    return c;
  };
  for (Contact const& c : found) {
    PairForce const f = pair_force(p, s, c);
    exert(c, f.elastic_x + f.dissipative_x, f.elastic_y + f.dissipative_y, f, change);
    ++count[c.i];
    ++count[c.j];
  }
  std::vector<std::array<double, 3>> alone(s.count(), {0.0, 0.0, 0.0});
  add_drive(system, s, alone);
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const m = mass(p, s.diameter[i]);
    for (int a = 0; a < 2; ++a) change.velocity[i][a] += alone[i][a] * dt / m;
    if (rotates(p)) change.spin[i] += alone[i][2] * dt / moment_of_inertia(p, s.diameter[i]);
  }
  all = change;
  for (std::size_t i = 0; i < s.count(); ++i) {  // the drag of the changes, each disk's own alpha
    double const z = p.drag * dt / mass(p, s.diameter[i]);
    for (int a = 0; a < 2; ++a) all.velocity[i][a] -= second_share(z) * z * change.velocity[i][a];
    if (!rotates(p)) continue;
    double const z_r = spin_drag(p, s.diameter[i]) * dt / moment_of_inertia(p, s.diameter[i]);
    all.spin[i] -= second_share(z_r) * z_r * change.spin[i];
  }
  std::vector<PairForce> second;
  for (Contact const& contact : found) {
    Contact const c = changed(contact, change);
    second.push_back(pair_force(second_law(p, s, c, std::max(count[c.i], count[c.j])), change, c));
    exert(c, second.back().dissipative_x, second.back().dissipative_y, second.back(), all);
  }
  StepPower power;
  for (std::size_t k = 0; k < found.size(); ++k) {
    Contact const& c = found[k];
    PairForce const first = pair_force(p, s, c);
    auto const before = damped_velocity(p, s, c);
    auto const gained = damped_velocity(p, all, changed(c, all));
    double const force[2] = {first.dissipative_x + second[k].dissipative_x,
                             first.dissipative_y + second[k].dissipative_y};
    for (int a = 0; a < 2; ++a) power.dissipation -= force[a] * (before[a] + 0.5 * gained[a]);
  }
  for (std::size_t i = 0; i < s.count(); ++i) {
    for (int a = 0; a < 2; ++a) {
      s.velocity[i][a] += all.velocity[i][a];
      s.position[i][a] += s.velocity[i][a] * dt;
    }
    if (!rotates(p)) continue;
    double const before = s.spin[i];
    s.spin[i] += all.spin[i];
    power.torque +=
        0.5 * moment_of_inertia(p, s.diameter[i]) * (s.spin[i] * s.spin[i] - before * before) / dt;
  }
  ++system.step;
  wrap(p, s, strain(system));
  s.offset = reduced_offset(strain(system), s);
  s.time = system.initial_time + dt * static_cast<double>(system.step);
  return power;
}

}  // namespace bagnold::reference
