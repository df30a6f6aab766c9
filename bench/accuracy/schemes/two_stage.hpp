// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/pair_relaxation.hpp"
#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// One evaluation of the force and a cheap second look at its damping:
///
///     a_i = [f_el(r_n) + f_dis(r_n, v)]_i dt/m_i                 what v changes by at first sight
///     b_i = sum_c alpha_c f_dis,c(r_n, a) dt/m_i                 the damping of that change
///     v <- v + a + b,   r_n+1 = r_n + v dt
///
/// and the spin alike. alpha = 1/2 for all is the Taylor series of exp(-A dt) to second order, stable
/// for A dt < 2; a smaller one is stable up to 1/alpha, as long as it is above 1/8 (the polynomial
/// 1 - y + alpha y^2 of a two-stage Runge-Kutta-Chebyshev method). A contact whose disks have n at
/// most, with z = k_d dt (1/mu) for the faster of its two relaxations, has
///
///     alpha = max{1/7, (n z - 1 + exp(-n z))/(n z)^2},
///
/// with which two disks alone (n = 1) relax exactly, by exp(-z).
template <class World>
struct TwoStage {
  static constexpr std::string_view name = "two-stage";
  using Pair = typename World::Pair;
  using Motions = typename World::Motions;

  Real least = 1.0 / 7;
  bool own_normal = false;
  int stages = 2;

  typename World::Touches touches;
  Motions change, second;
  std::vector<int> contacts;
  std::vector<Vec2<Pair>> given;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    change.assign(world.size(), {});
    kick_elastic(world, touches, dt, change);
    kick_dissipative(world, touches, dt, world.motion, change);
    ++world.counts.damping_passes;
    if (sample) {
      given.resize(touches.size());
      for (std::size_t k = 0; k < touches.size(); ++k)
        given[k] = static_cast<Pair>(dt) * world.law.dissipative_force(contact_of(world, touches[k], world.motion));
      sample_elastic(world, touches, *sample);
      sample_motion(world, world.position, world.motion, 1, *sample);
    }
    contacts.assign(world.size(), 0);
    for (auto const& t : touches) ++contacts[t.i], ++contacts[t.j];
    second.assign(world.size(), {});
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto t = touches[k];
      t.velocity_shift = 0;
      int const n = std::max(contacts[t.i], contacts[t.j]);
      auto const c = contact_of(world, t, change);
      auto f = static_cast<Pair>(dt * alpha(world, t.big, n)) * world.law.dissipative_force(c);
      exert(world, t, f, second);
      if (sample) given[k] += f;
    }
    ++world.counts.damping_passes;
    if (sample) change_of(world, *sample, dt);
    for (std::size_t i = 0; i < world.size(); ++i) {
      world.motion[i].velocity += change[i].velocity + second[i].velocity;
      world.motion[i].spin += change[i].spin + second[i].spin;
      world.position[i] += world.time_step() * world.motion[i].velocity;
    }
    world.finish_step();
  }

 private:
  Real alpha(World const& world, int big, int n) const {
    int const a = big == 2 ? 1 : 0, b = big == 0 ? 0 : 1;
    Real const inverse = world.table.inverse_mass[a] + world.table.inverse_mass[b];
    Real const faster = World::rotates ? 3 : 1;
    Real const z = n * world.clock.time_step * inverse *
                   std::max(normal_damping(world.law), faster * tangential_damping(world.law));
    Real const exact = z < 1e-3 ? 0.5 - z / 6 : (z + std::expm1(-z)) / (z * z);
    return std::max(least, exact);
  }

  void change_of(World const& world, Sample& sample, double dt) {
    Motions after = world.motion;
    for (std::size_t i = 0; i < world.size(); ++i) {
      after[i].velocity += change[i].velocity + second[i].velocity;
      after[i].spin += change[i].spin + second[i].spin;
    }
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto const before = contact_of(world, touches[k], world.motion);
      auto const now = contact_of(world, touches[k], after);
      auto const f = (1 / dt) * wide(given[k]);
      sample.add_dissipative(f, wide(touches[k].separation),
                             -0.5 * dot(f, wide(before.velocity) + wide(now.velocity)));
    }
  }
};

}  // namespace bagnold::accuracy
