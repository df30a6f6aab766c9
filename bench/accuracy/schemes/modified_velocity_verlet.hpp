// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// The papers' scheme, P2 Eqs. (21)-(24), the spin like the velocity:
///
///     v~ = v_0 + f(r_0, v_0) dt/m,   r~ = r_0 + v_0 dt
///     v_1 = v_0 + [f(r_0, v_0) + f(r~, v~)] dt/2m,   r_1 = r_0 + (v_0 + v_1) dt/2
template <class World>
struct ModifiedVelocityVerlet {
  static constexpr std::string_view name = "modified-velocity-verlet";
  static constexpr bool staggered = false;

  typename World::Positions trial_position;
  typename World::Motions trial, after;
  typename World::Touches touches;

  void step(World& world, Sample* sample) {
    using Kept = typename World::Kept;
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_dissipative(world, touches, world.motion, *sample);
      sample_motion(world, world.position, world.motion, *sample);
    }
    trial = after = world.motion;
    kick(world, dt, world.motion, trial);
    kick(world, dt / 2, world.motion, after);
    trial_position = world.position;
    for (std::size_t i = 0; i < world.size(); ++i)
      trial_position[i] += world.time_step() * world.motion[i].velocity;
    world.find_touches(trial_position, world.step + 1, touches);
    kick(world, dt / 2, trial, after);
    for (std::size_t i = 0; i < world.size(); ++i)
      world.position[i] +=
          Kept(0.5) * world.time_step() * (world.motion[i].velocity + after[i].velocity);
    std::swap(world.motion, after);
    world.finish_step();
  }

 private:
  void kick(World& world, double time, typename World::Motions const& felt,
            typename World::Motions& motion) {
    kick_elastic(world, touches, time, motion);
    kick_dissipative(world, touches, time, felt, motion);
    ++world.counts.damping_passes;
  }
};

}  // namespace bagnold::accuracy
