// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/increments.hpp"
#include "bench/accuracy/schemes/pair_relaxation.hpp"
#include "kernels/physics/schemes/two_stage_leapfrog.hpp"

namespace bagnold::accuracy {

/// One evaluation of the force, and a second stage for its contacts: the damping of the change
/// that it makes.
///
///     a_i = [f_el(r_n) + f_dis(r_n, v)]_i dt/m_i
///     b_i = sum_c alpha_c f_dis,c(r_n, a) dt/m_i
///     v <- v + a + b,   r_n+1 = r_n + v dt
///
/// and the spin alike. In each of both stages all contacts read the same numbers: nothing depends
/// on their order. A relaxation of rate y/dt shrinks by 1 - y + alpha y^2: with alpha = 1/2 the
/// series of exp(-y) to second order, stable below y = 2; with less, down to 1/8, stable up to
/// 1/alpha, the polynomial of a two-stage Runge-Kutta-Chebyshev method. Normal and tangential, each
/// with its z,
///
///     alpha = TwoStageLeapfrog::share(N z),   N the larger number of contacts of the two disks.
///
/// Two disks alone (N = 1) relax exactly. For more, dt A = G C G^T with the matrix C of the z, and
/// the second stage takes off S = G (alpha C) G^T; masses cut in N parts bound it, S <= 1, so that
/// the eigenvalues of 1 - dt A + S dt A are real and between -1 and 1 as long as N z < 7.
template <class World>
struct TwoStage {
  static constexpr std::string_view name = "two-stage";
  static constexpr bool staggered = true;
  using Pair = typename World::Pair;

  typename World::Touches touches;
  typename World::Motions change, first;
  std::vector<Vec2<Pair>> impulse;
  std::vector<int> contacts;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    change.assign(world.size(), {});
    kick_elastic(world, touches, dt, change);
    kick_dissipative(world, touches, dt, world.motion, change);
    first = change;
    contacts.assign(world.size(), 0);
    for (auto const& t : touches) ++contacts[t.i], ++contacts[t.j];
    impulse.resize(touches.size());
    PairRelaxation const by(world.law, world.table, dt);
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto const& t = touches[k];
      int const n = std::max(contacts[t.i], contacts[t.j]);
      auto const share = [n](Relaxing const& r) {
        return r.mass * r.steps * TwoStageLeapfrog::share(n * r.steps);
      };
      impulse[k] = along(t, change_of(world, t, first).velocity, share(by.normal[t.big]),
                         share(by.tangential[t.big]));
      exert(world, t, impulse[k], change);
    }
    world.counts.damping_passes += 2;
    finish(world, touches, change, impulse, sample);
  }
};

}  // namespace bagnold::accuracy
