// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/physics/motion.hpp"

namespace bagnold {

/// Adds to the motion of a disk what the mean flow gains where the strain rate changes: the excess
/// over it stays.
template <bool Rotates, class Space>
struct FollowFlow {
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> position;
  Real rise;  ///< of the strain rate, [1 / tau_e]

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    motion(i).velocity.x += rise * position(i).y;
    if constexpr (Rotates) motion(i).spin -= rise / 2;
  }
};

}  // namespace bagnold
