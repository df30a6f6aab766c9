// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tests/reference/system.hpp"
#include "tests/reference/two_stage.hpp"

namespace bagnold::reference {

/// Velocities and spins of all disks, or changes of them: {v_x, v_y, thetadot} each.
using Motions = std::vector<std::array<double, 3>>;

/// sum |u|^2 of one disk of mass 1, u = v + (d/2) thetadot t at each contact, at most: so many
/// contacts side by side, small disks around a big one, by power iteration. Without spins the
/// number of contacts.
inline double contact_weight(int contacts, bool rolling) {
  if (!rolling || contacts == 0) return contacts;
  // 4000 iterations for each disk and step would take longer than all else
  static std::map<int, double> known;
  auto const [at, fresh] = known.try_emplace(contacts, 0.0);
  if (!fresh) return at->second;
  double const angle = 2 * std::asin(1.0 / 2.4), inertia = 1.0 / 8.0;  // of d = 1
  double matrix[3][3] = {};  // in v_x, v_y, sqrt(I) thetadot
  for (int c = 0; c < contacts; ++c) {
    double const t[2] = {-std::sin(c * angle), std::cos(c * angle)};
    double const arm = 0.5 / std::sqrt(inertia);
    double const u[2][3] = {{1, 0, arm * t[0]}, {0, 1, arm * t[1]}};
    for (auto const& row : u)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) matrix[a][b] += row[a] * row[b];
  }
  std::array<double, 3> x{0.3, 0.5, 1.0};
  for (int k = 0; k < 4000; ++k) {
    std::array<double, 3> y{};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) y[a] += matrix[a][b] * x[b];
    at->second = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
    for (int a = 0; a < 3; ++a) x[a] = y[a] / at->second;
  }
  return at->second;
}

/// Powers of an implicit step, and what its iterations leave of the equation, in the norm of the
/// kinetic energy: a share of its right side, and how large it may be.
struct ImplicitPower : StepPower {
  double left = 0.0, allowed = 0.0;
};

/// Chebyshev iterations of a step.
inline int chebyshev_iterations(bool rotates) { return rotates ? 5 : 3; }

/// Lift s of their polynomial.
inline constexpr double lift = 0.5;

/// Largest part that Chebyshev iterations leave of a right side: (1 + s)/(T_n(1 + 2/bound) + s).
inline double left_at_most(int iterations, double bound) {
  return (1 + lift) / (std::cosh(iterations * std::acosh(1 + 2 / bound)) + lift);
}

/// A step of the leapfrog with implicit damping. w is solved to rounding, by conjugate gradients:
/// with 0 iterations for a, else for a less what as many Chebyshev iterations leave of it,
/// [T_n(1 - 2 B/bound) + s] a / [T_n(1 + 2/bound) + s], by the recurrence of T_n. dissipative: out,
/// sum f_a r_b of the damping of v + w.
inline ImplicitPower implicit_step(System& system, int iterations, double (&dissipative)[2][2]) {
  Parameters const& p = system.p;
  State& s = system.s;
  double const dt = p.time_step;
  auto const found = contacts(system);
  auto const of = [&](Motions const& motions) {
    State state = s;
    for (std::size_t i = 0; i < s.count(); ++i) {
      state.velocity[i] = {motions[i][0], motions[i][1]};
      if (rotates(p)) state.spin[i] = motions[i][2];
    }
    return state;
  };
  auto const masses = [&](std::size_t i, int a) {
    return a == 2 ? moment_of_inertia(p, s.diameter[i]) : mass(p, s.diameter[i]);
  };
  auto const exert = [&](Contact const& c, double x, double y, PairForce const& f, Motions& on) {
    double const load_i[3] = {x, y, f.torque_i}, load_j[3] = {-x, -y, f.torque_j};
    for (int a = 0; a < (rotates(p) ? 3 : 2); ++a) {
      on[c.i][a] += load_i[a] * dt / masses(c.i, a);
      on[c.j][a] += load_j[a] * dt / masses(c.j, a);
    }
  };
  auto const moving = [](Contact c, State const& by) {
    c.velocity_x = by.velocity[c.i][0] - by.velocity[c.j][0];
    c.velocity_y = by.velocity[c.i][1] - by.velocity[c.j][1];
    return c;
  };
  Motions const none(s.count(), {0, 0, 0});
  auto const damping = [&](Motions const& motions) {  // dt f_dis/m
    State const state = of(motions);
    Motions change = none;
    for (Contact const& contact : found) {
      auto const c = moving(contact, state);
      auto const f = pair_force(p, state, c);
      exert(c, f.dissipative_x, f.dissipative_y, f, change);
    }
    return change;
  };
  auto const combined = [&](double a, Motions const& x, double b, Motions const& y) {
    Motions sum = none;
    for (std::size_t i = 0; i < sum.size(); ++i)
      for (int k = 0; k < 3; ++k) sum[i][k] = a * x[i][k] + b * y[i][k];
    return sum;
  };
  auto const product = [&](Motions const& x, Motions const& y) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int k = 0; k < 3; ++k) sum += masses(i, k) * x[i][k] * y[i][k];
    return sum;
  };

  Motions a = none;
  std::vector<int> count(s.count(), 0);
  for (Contact const& c : found) {
    PairForce const f = pair_force(p, s, c);
    exert(c, f.elastic_x + f.dissipative_x, f.elastic_y + f.dissipative_y, f, a);
    ++count[c.i];
    ++count[c.j];
  }
  double bound = 0, damped = 1 / p.elasticity;
  if (p.model == Parameters::Model::CD_nt)
    damped *= std::max(p.damping_normal, p.damping_tangential);
  for (std::size_t i = 0; i < s.count(); ++i)
    bound = std::max(
        bound, 2 * damped * dt / mass(p, s.diameter[i]) * contact_weight(count[i], rotates(p)));
  Motions solved_for = a;
  if (iterations > 0 && bound > 0) {
    auto const mapped = [&](Motions const& x) { return combined(1, x, 2 / bound, damping(x)); };
    double const outside = 1 + 2 / bound;
    Motions before = a, now = mapped(a);
    double before_outside = 1, now_outside = outside;
    for (int k = 1; k < iterations; ++k) {
      before = std::exchange(now, combined(2, mapped(now), -1, before));
      before_outside = std::exchange(now_outside, 2 * outside * now_outside - before_outside);
    }
    double const whole = now_outside + lift;
    solved_for = combined(1 - lift / whole, a, -1 / whole, now);
  }
  Motions w = none, left = solved_for, direction = left;
  double left2 = product(left, left);
  for (double const start2 = left2; left2 > 1e-30 * start2;) {
    auto const applied = combined(1, direction, -1, damping(direction));
    double const along = left2 / product(direction, applied);
    w = combined(1, w, along, direction);
    left = combined(1, left, -along, applied);
    double const before2 = std::exchange(left2, product(left, left));
    direction = combined(1, left, left2 / before2, direction);
  }
  if (iterations > 0) left = combined(1, a, -1, combined(1, w, -1, damping(w)));

  ImplicitPower power;
  if (bound > 0) {
    power.left = std::sqrt(product(left, left) / product(a, a));
    power.allowed = left_at_most(iterations, bound);
  }
  for (auto& row : dissipative) row[0] = row[1] = 0.0;
  Motions after = none, halfway = none;
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const before[3] = {s.velocity[i][0], s.velocity[i][1], rotates(p) ? s.spin[i] : 0};
    for (int k = 0; k < 3; ++k) {
      after[i][k] = before[k] + w[i][k];
      halfway[i][k] = before[k] + w[i][k] / 2;
    }
    double const flow = p.strain_rate * s.position[i][1];
    for (int k = 0; k < 3; ++k)
      power.dissipation += masses(i, k) / dt * left[i][k] * (halfway[i][k] - (k == 0 ? flow : 0.0));
    if (rotates(p)) power.torque += masses(i, 2) / dt * w[i][2] * halfway[i][2];
  }
  auto const undamped = [&](Contact const& contact, Motions const& motions, double share) {
    Contact c = contact;  // with the shear of its image
    c.velocity_x += share * (w[c.i][0] - w[c.j][0]);
    c.velocity_y += share * (w[c.i][1] - w[c.j][1]);
    return std::pair{of(motions), c};
  };
  for (Contact const& contact : found) {
    auto const [end, c] = undamped(contact, after, 1);
    PairForce const f = pair_force(p, end, c);
    auto const [middle, c_middle] = undamped(contact, halfway, 0.5);
    auto const v = damped_velocity(p, middle, c_middle);
    double const force[2] = {f.dissipative_x, f.dissipative_y}, r[2] = {c.x, c.y};
    for (int k = 0; k < 2; ++k) {
      power.dissipation -= force[k] * v[k];
      for (int b = 0; b < 2; ++b) dissipative[k][b] += force[k] * r[b];
    }
  }
  for (std::size_t i = 0; i < s.count(); ++i) {
    for (int k = 0; k < 2; ++k) {
      s.velocity[i][k] = after[i][k];
      s.position[i][k] += s.velocity[i][k] * dt;
    }
    if (rotates(p)) s.spin[i] = after[i][2];
  }
  ++system.step;
  wrap(p, s, strain(system));
  s.offset = reduced_offset(strain(system), s);
  s.time = system.initial_time + dt * static_cast<double>(system.step);
  return power;
}

}  // namespace bagnold::reference
