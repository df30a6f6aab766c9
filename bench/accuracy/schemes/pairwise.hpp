// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/pair_relaxation.hpp"
#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// In which order a step goes over the contacts.
enum class Order {
  forward,      ///< always as they lie in the list
  alternating,  ///< odd steps backwards
  symmetric     ///< half the time forwards, half backwards: twice the passes
};

/// When the elastic impulse acts.
enum class Elastic {
  half,    ///< half before, half after the damping
  fitted,  ///< a share theta before it, so that one contact alone ends at f_el/k_d exactly
  within   ///< with the damping, pair by pair
};

struct PairwiseOptions {
  Relaxation relaxation = Relaxation::exact;
  Order order = Order::alternating;
  Elastic elastic = Elastic::half;
  int across = 1;  ///< pairs across blocks: parts that masses are split in; 0: as many as contacts
};

/// One evaluation of the elastic force a step, and the damping of each contact treated exactly or
/// implicitly, one pair after the other:
///
///     v' = v_- + theta f_el(r_n) dt/m
///     for each contact c:  v' <- exp(-A_c dt) v'
///     v_+ = v' + (1 - theta) f_el(r_n) dt/m,   r_n+1 = r_n + v_+ dt
template <class World>
struct Pairwise {
  static constexpr std::string_view name = "pairwise";
  using Kept = typename World::Kept;
  using Pair = typename World::Pair;
  using Motions = typename World::Motions;
  using Touches = typename World::Touches;

  PairwiseOptions options;
  Touches touches;
  Motions start;
  std::vector<int> parts;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_motion(world, world.position, world.motion, 1, *sample);
    }
    double const before = share_before(world);
    if (options.elastic != Elastic::within) kick_elastic(world, touches, before * dt, world.motion);
    bool const backwards = options.order == Order::alternating && world.step % 2 != 0;
    if (options.order == Order::symmetric) {
      sweep(world, dt / 2, false, sample);
      sweep(world, dt / 2, true, sample);
    } else {
      sweep(world, dt, backwards, sample);
    }
    if (options.elastic != Elastic::within)
      kick_elastic(world, touches, (1 - before) * dt, world.motion);
    for (std::size_t i = 0; i < world.size(); ++i)
      world.position[i] += world.time_step() * world.motion[i].velocity;
    world.finish_step();
  }

 private:
  /// theta = 1/(1 - E) - 1/z for E = exp(-z): then v = E (v + theta g) + (1 - theta) g is g/z.
  double share_before(World const& world) const {
    if (options.elastic != Elastic::fitted) return 0.5;
    double const z = normal_damping(world.law) * world.clock.time_step * 2 * world.table.inverse_mass[0];
    return z < 1e-4 ? 0.5 : 1 / share_lost(options.relaxation, z) - 1 / z;
  }

  void sweep(World& world, double time, bool backwards, Sample* sample) {
    std::size_t const across = world.across(), count = touches.size();
    if (across > 0) relax_across(world, time, across, sample);
    PairRelaxation const by(world.law, world.table, options.relaxation, time);
    for (std::size_t k = across; k < count; ++k)
      relax(world, touches[backwards ? count - 1 - (k - across) : k], by, time, world.motion,
            world.motion, sample);
    ++world.counts.damping_passes;
  }

  /// Pairs across blocks, all from the same velocities.
  void relax_across(World& world, double time, std::size_t across, Sample* sample) {
    start = world.motion;
    if (options.across == 0) {
      parts.assign(world.size(), 0);
      for (std::size_t k = 0; k < across; ++k) ++parts[touches[k].i], ++parts[touches[k].j];
      std::vector<PairRelaxation> by;
      for (int n = 0; n <= 8; ++n)
        by.emplace_back(world.law, world.table, options.relaxation, time, n == 0 ? 1 : n);
      for (std::size_t k = 0; k < across; ++k) {
        auto const& t = touches[k];
        relax(world, t, by[std::max(parts[t.i], parts[t.j])], time, start, world.motion, sample);
      }
      return;
    }
    PairRelaxation const by(world.law, world.table, options.relaxation, time, options.across);
    for (std::size_t k = 0; k < across; ++k)
      relax(world, touches[k], by, time, start, world.motion, sample);
  }

  void relax(World& world, Touch<Pair> const& t, PairRelaxation const& by, double time,
             Motions const& felt, Motions& motion, Sample* sample) {
    if (options.elastic == Elastic::within) kick(world, t, time / 2, motion);
    auto const contact = contact_of(world, t, felt);
    Pair const normal = static_cast<Pair>(by.normal[t.big]);
    Pair const tangential = static_cast<Pair>(by.tangential[t.big]);
    Vec2<Pair> const impulse = (tangential - normal) * dot(contact.velocity, t.normal) * t.normal -
                               tangential * contact.velocity;
    exert(world, t, impulse, motion);
    if (sample) add(world, t, contact, impulse, motion, *sample);
    if (options.elastic == Elastic::within) kick(world, t, time / 2, motion);
  }

  void kick(World& world, Touch<Pair> const& t, double time, Motions& motion) {
    Vec2<Kept> f{};
    auto const e = static_cast<Pair>(time) * elastic_force(world, t);
    f = {static_cast<Kept>(e.x), static_cast<Kept>(e.y)};
    motion[t.i].velocity += static_cast<Kept>(world.table.inverse_mass[world.species[t.i]]) * f;
    motion[t.j].velocity += static_cast<Kept>(-world.table.inverse_mass[world.species[t.j]]) * f;
  }

  /// The force is impulse/dt; the energy lost is that of the pair, before less after.
  void add(World const& world, Touch<Pair> const& t, Contact<Pair> const& before,
           Vec2<Pair> const& impulse, Motions const& motion, Sample& sample) const {
    auto const after = contact_of(world, t, motion);
    double const rate = 1 / world.clock.time_step;
    Vec2<double> const mean = 0.5 * (wide(before.velocity) + wide(after.velocity));
    sample.add_dissipative(rate * wide(impulse), wide(t.separation),
                           -rate * dot(wide(impulse), mean));
  }
};

}  // namespace bagnold::accuracy
