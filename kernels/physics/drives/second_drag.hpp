// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/drives/drive.hpp"

namespace bagnold {

/// Drag of the changes, in the second stage of a scheme: zeta share(zeta dt/m), with the share of
/// TwoStageLeapfrog, so that a free disk relaxes by e^-z exactly.
struct SecondDrag {
  PerSpecies drag;  ///< [m / tau_e]
  PerSpecies spin;  ///< [m d_s^2 / tau_e]

  explicit SecondDrag(DriveInput const& input) : drag{}, spin{} {
    if (input.scheme.share == nullptr) return;
    auto const of = [&](Real zeta, Real inverse_mass) {
      return zeta * input.scheme.share(zeta * input.time_step * inverse_mass);
    };
    auto const& table = input.table;
    auto const of_spin = [&](Species s) {
      return of(spin_drag(input.drag, table.diameter[s]), table.inverse_inertia[s]);
    };
    drag = {of(input.drag, table.inverse_mass[0]), of(input.drag, table.inverse_mass[1])};
    spin = {of_spin(0), of_spin(1)};
  }

  /// change: velocity and spin hold the changes of the first stage.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Push<T> operator()(DrivenDisk<T> const& change) const {
    return {-change.of(drag) * change.velocity, -change.of(spin) * change.spin};
  }
};

}  // namespace bagnold
