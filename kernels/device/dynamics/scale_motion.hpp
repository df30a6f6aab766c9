// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/physics/motion.hpp"

namespace bagnold {

/// Scales the motion of a disk with the strain rate, P2 Eqs. (40)-(41).
template <bool Rotates, class Space>
struct ScaleMotion {
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Real factor;  ///< of the strain rate

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    motion(i).velocity = factor * motion(i).velocity;
    if constexpr (Rotates) motion(i).spin *= factor;
  }
};

}  // namespace bagnold
