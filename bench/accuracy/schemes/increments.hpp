// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// A contact as changes of motion see it: images change like their disks, without shear.
template <class World>
Contact<typename World::Pair> change_of(World const& world, Touch<typename World::Pair> touch,
                                        typename World::Motions const& change) {
  touch.velocity_shift = 0;
  return contact_of(world, touch, change);
}

/// Ends a step in which motions change by `change`, as contacts gave `impulse` beyond what their
/// elastic force and their damping of the motion at the step's start did.
template <class World>
void finish(World& world, typename World::Touches const& touches,
            typename World::Motions const& change,
            std::vector<Vec2<typename World::Pair>> const& impulse, Sample* sample) {
  auto const before = world.motion;
  for (std::size_t i = 0; i < world.size(); ++i) {
    world.motion[i].velocity += change[i].velocity;
    world.motion[i].spin += change[i].spin;
  }
  if (sample) {
    sample_elastic(world, touches, *sample);
    sample_motion(world, world.position, before, *sample);
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto const from = contact_of(world, touches[k], before);
      auto const first = world.clock.time_step * wide(world.law.dissipative_force(from));
      sample_impulse(world, touches[k], first + wide(impulse[k]), from,
                     contact_of(world, touches[k], world.motion), *sample);
    }
  }
  world.fly();
  world.finish_step();
}

}  // namespace bagnold::accuracy
