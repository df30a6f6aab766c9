// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/clock.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

/// A system's disks as they are on the device, outside the box perhaps. diameter: [N], [d_s].
template <bool Rotates, class Space>
State download_state(Kokkos::View<Vec2<Real>*, Space> const& position,
                     Kokkos::View<Motion<Rotates>*, Space> const& motion,
                     std::vector<double> const& diameter, Clock const& clock, std::int64_t step) {
  State state;
  state.position = pairs(to_host(position));
  split_motions(to_host(motion), state);
  state.diameter = diameter;
  clock.tell(state, step);
  return state;
}

}  // namespace bagnold
