// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/increments.hpp"
#include "bench/accuracy/schemes/pair_relaxation.hpp"

namespace bagnold::accuracy {

/// One evaluation of the force, and a sweep over its contacts that holds back the change it makes:
///
///     a = [f_el(r_n) + f_dis(r_n, v)] dt/m
///     for each contact c:  a <- phi(A_c dt) a,   phi(z) = (1 - exp(-z))/z
///     v <- v + a,   r_n+1 = r_n + v dt
///
/// Exact for two disks alone (exponential Euler). In a flow that hardly changes a is small, and
/// with it all that the splitting does wrong. Always in the same direction: alternating is less
/// stable.
///
/// Pairs across blocks come first, all from the same increments, with masses cut in two: both
/// blocks can work them out, and no count of contacts is needed.
template <class World>
struct IncrementSweep {
  static constexpr std::string_view name = "increment-sweep";
  static constexpr bool staggered = true;
  using Pair = typename World::Pair;

  typename World::Touches touches;
  typename World::Motions change, start;
  std::vector<Vec2<Pair>> impulse;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    change.assign(world.size(), {});
    kick_elastic(world, touches, dt, change);
    kick_dissipative(world, touches, dt, world.motion, change);
    impulse.resize(touches.size());
    std::size_t const across = world.across();
    if (across > 0) {
      start = change;
      PairRelaxation const halved(world.law, world.table, dt, 2);
      for (std::size_t k = 0; k < across; ++k) hold(world, k, halved, start);
    }
    PairRelaxation const by(world.law, world.table, dt);
    for (std::size_t k = across; k < touches.size(); ++k) hold(world, k, by, change);
    world.counts.damping_passes += 2;
    finish(world, touches, change, impulse, sample);
  }

 private:
  void hold(World& world, std::size_t k, PairRelaxation const& by,
            typename World::Motions const& felt) {
    auto const& t = touches[k];
    impulse[k] = along(t, change_of(world, t, felt).velocity, by.normal[t.big].holding(),
                       by.tangential[t.big].holding());
    exert(world, t, impulse[k], change);
  }
};

}  // namespace bagnold::accuracy
