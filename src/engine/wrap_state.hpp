// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/box/sheared_box.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// State of an engine with all disks wrapped into the box. Between list builds the offset may have
/// passed L_x: the images are the same.
inline State wrap_state(State state) {
  ShearedBox const box{state.box_length, state.offset, state.strain_rate.value(),
                       state.box_height()};
  for (std::size_t i = 0; i < state.count(); ++i) {
    Vec2<Real> position{state.position[i][0], state.position[i][1]};
    wrap(box, position, state.velocity[i][0]);
    state.position[i] = {position.x, position.y};
  }
  return state;
}

}  // namespace bagnold
