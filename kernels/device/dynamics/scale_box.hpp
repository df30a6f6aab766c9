// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/physics/motion.hpp"

namespace bagnold {

/// Maps a disk affinely where the box is scaled. Its velocity keeps the excess over the mean flow.
template <bool Rotates, class Space>
struct ScaleBox {
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> position;
  Real scale;
  Real rise;  ///< of the mean flow at a disk, over its y, [1 / tau_e]

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    motion(i).velocity.x += rise * position(i).y;
    position(i) = scale * position(i);
  }
};

}  // namespace bagnold
