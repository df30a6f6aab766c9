// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Motion of one disk. A law without rotation has no spin: not zero, but absent.
template <bool Rotates>
struct Motion {
  Vec2<Real> velocity{};  ///< lab frame, [d_s / tau_e]
};

template <>
struct Motion<true> {
  Vec2<Real> velocity{};
  Real spin{};  ///< thetadot, counter-clockwise, [1 / tau_e]
};

/// Force and torque on one disk.
template <bool Rotates>
struct Load {
  Vec2<Real> force{};  ///< [m d_s / tau_e^2]
};

template <>
struct Load<true> {
  Vec2<Real> force{};
  Real torque{};  ///< [m d_s^2 / tau_e^2]
};

}  // namespace bagnold
