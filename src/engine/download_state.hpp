// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/clock.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

/// Disks of a system in their state on the device, which may be outside the box. All [N].
template <bool Rotates>
State state_of(std::vector<Vec2<Real>> const& position, std::vector<Motion<Rotates>> const& motion,
               std::vector<double> const& diameter, Clock const& clock, std::int64_t step) {
  State state;
  state.position = pairs(position);
  split_motions(motion, state);
  state.diameter = diameter;
  clock.tell(state, step);
  return state;
}

}  // namespace bagnold
