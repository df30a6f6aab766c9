// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// Velocity Verlet whose damping feels a predicted velocity, Groot and Warren, J. Chem. Phys. 107,
/// 4423 (1997), Eq. (19):
///
///     r_1 = r_0 + v_0 dt + f_0 dt^2/2m,   v~ = v_0 + lambda f_0 dt/m,
///     f_1 = f(r_1, v~),   v_1 = v_0 + (f_0 + f_1) dt/2m
///
/// lambda = 1/2 is the previous half step's velocity, as LAMMPS has it; 0.65 is theirs.
template <class World>
struct GrootWarren {
  static constexpr std::string_view name = "groot-warren";
  static constexpr bool staggered = false;
  using Kept = typename World::Kept;

  double lambda = 0.65;
  typename World::Motions felt;  ///< v~
  typename World::Motions rate;  ///< f_0/m and torque/I; empty before the first step
  typename World::Touches touches;

  void step(World& world, Sample* sample) {
    if (rate.empty()) {
      world.find_touches(world.position, world.step, touches);
      felt = world.motion;
      evaluate(world);
    }
    double const dt = world.clock.time_step;
    for (std::size_t i = 0; i < world.size(); ++i) {
      felt[i] = advanced(world.motion[i], rate[i], lambda * dt);
      world.motion[i] = advanced(world.motion[i], rate[i], dt / 2);
      world.position[i] += world.time_step() * world.motion[i].velocity;
    }
    world.find_touches(world.position, world.step + 1, touches);
    evaluate(world);
    for (std::size_t i = 0; i < world.size(); ++i)
      world.motion[i] = advanced(world.motion[i], rate[i], dt / 2);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_dissipative(world, touches, felt, *sample);
      sample_motion(world, world.position, world.motion, *sample);
    }
    world.finish_step();
  }

 private:
  static Moving<Kept> advanced(Moving<Kept> motion, Moving<Kept> const& rate, double time) {
    motion.velocity += static_cast<Kept>(time) * rate.velocity;
    motion.spin += static_cast<Kept>(time) * rate.spin;
    return motion;
  }

  void evaluate(World& world) {
    rate.assign(world.size(), {});
    kick_elastic(world, touches, 1, rate);
    kick_dissipative(world, touches, 1, felt, rate);
    ++world.counts.damping_passes;
  }
};

/// The same with lambda = 1/2.
template <class World>
struct LaggedVelocityVerlet : GrootWarren<World> {
  static constexpr std::string_view name = "lagged-velocity-verlet";
  LaggedVelocityVerlet() { this->lambda = 0.5; }
};

}  // namespace bagnold::accuracy
