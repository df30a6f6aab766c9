// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/drives/drive.hpp"

namespace bagnold {

/// Drag of a fluid that moves with the mean flow, P2 Sec. IV: drag_force(), without a push.
struct StokesDrag {
  static constexpr std::string_view name = "stokes";
  static constexpr bool random = false;
  static constexpr bool thermal = false;
  Real drag;  ///< zeta, [m / tau_e]

  static StokesDrag make(DriveInput const& input) { return {input.drag}; }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Push<T> push(DrivenDisk<T> const&) const {
    return {};
  }
};
static_assert(OneBodyDrive<StokesDrag>);

}  // namespace bagnold
