// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/pair_relaxation.hpp"
#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// The elastic force once a step, and the damping of each contact exactly, one pair after the
/// other: a splitting, of second order as odd steps go backwards through the contacts. Shardlow,
/// SIAM J. Sci. Comput. 24, 1267 (2003), does the same for dissipative particles.
///
///     v' = v + f_el(r_n) dt/2m;   for each contact c:  v' <- exp(-A_c dt) v'
///     v <- v' + f_el(r_n) dt/2m,   r_n+1 = r_n + v dt
///
/// Stable at any step, and biased: where forces balance damping, the contacts of a disk pull its
/// velocity to and fro within a step.
template <class World>
struct PairwiseSweep {
  static constexpr std::string_view name = "pairwise-sweep";
  static constexpr bool staggered = true;
  using Pair = typename World::Pair;

  typename World::Touches touches;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_motion(world, world.position, world.motion, *sample);
    }
    kick_elastic(world, touches, dt / 2, world.motion);
    PairRelaxation const by(world.law, world.table, dt);
    std::size_t const count = touches.size();
    bool const backwards = world.step % 2 != 0;
    for (std::size_t k = 0; k < count; ++k)
      relax(world, touches[backwards ? count - 1 - k : k], by, sample);
    ++world.counts.damping_passes;
    kick_elastic(world, touches, dt / 2, world.motion);
    world.fly();
    world.finish_step();
  }

 private:
  void relax(World& world, Touch<Pair> const& t, PairRelaxation const& by, Sample* sample) {
    auto const before = contact_of(world, t, world.motion);
    auto const impulse =
        along(t, before.velocity, by.normal[t.big].slowing(), by.tangential[t.big].slowing());
    exert(world, t, impulse, world.motion);
    if (!sample) return;
    auto const after = contact_of(world, t, world.motion);
    sample_impulse(world, t, wide(impulse), before, after, *sample);
  }
};

}  // namespace bagnold::accuracy
