// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/scheme.hpp"
#include "kernels/physics/schemes/modified_velocity_verlet.hpp"

namespace bagnold::accuracy {

/// The papers' scheme, bagnold::ModifiedVelocityVerlet, contact by contact.
template <class World>
struct ModifiedVelocityVerlet {
  using Formulas = bagnold::ModifiedVelocityVerlet;
  static constexpr std::string_view name = Formulas::name;
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
    trial_position.resize(world.size());
    for (std::size_t i = 0; i < world.size(); ++i)
      trial_position[i] =
          Formulas::trial_position(world.position[i], world.motion[i].velocity, world.time_step());
    world.find_touches(trial_position, world.step + 1, touches);
    kick(world, dt / 2, trial, after);
    for (std::size_t i = 0; i < world.size(); ++i)
      world.position[i] = Formulas::position(world.position[i], world.motion[i].velocity,
                                             after[i].velocity, Kept(0.5) * world.time_step());
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
