// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/physics/drives/drive.hpp"

namespace bagnold {

/// A fluid at temperature T that drags the disks and pushes them at random, P2 Sec. IV, so that
/// m <dv_a^2> = I <dthetadot^2> = T of a free disk, and of one whose contacts lose nothing.
///
/// In continuous time the forces obey fluctuation and dissipation, <f(t) f(t')> = 2 zeta T delta(t
/// - t'), the torques alike with zeta_r. In steps v -> v + K (s - z v), where s is the push times
/// dt/m, z = zeta dt/m and K the gain of the scheme, and
///
///     <s^2> = (T/m) z (2 - z K)/K
///
/// holds <v^2> = T/m at any step. s is even in an interval, which gives no other mean square and,
/// many pushes in a relaxation time, no other distribution (Duenweg and Paul, Int. J. Mod. Phys. C
/// 2, 817 (1991)).
struct ThermalBath {
  static constexpr std::string_view name = "thermal";
  static constexpr bool random = true;
  static constexpr bool thermal = true;
  Real drag;          ///< zeta, [m / tau_e]
  PerSpecies force;   ///< width of the interval, [m d_s / tau_e^2]
  PerSpecies torque;  ///< [m d_s^2 / tau_e^2]

  static ThermalBath make(DriveInput const& input) {
    auto const width = [&](Real drag, Real inverse_mass) {
      Real const z = drag * input.time_step * inverse_mass;
      Real const gain = input.scheme.gain(z);
      Real const square = input.temperature * inverse_mass * z * (2 - z * gain) / gain;
      return std::sqrt(12 * square) / (input.time_step * inverse_mass);
    };
    auto const& table = input.table;
    auto const on_spin = [&](Species s) {
      return width(spin_drag(input.drag, table.diameter[s]), table.inverse_inertia[s]);
    };
    return {input.drag,
            {width(input.drag, table.inverse_mass[0]), width(input.drag, table.inverse_mass[1])},
            {on_spin(0), on_spin(1)}};
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION Push<T> push(DrivenDisk<T> const& disk) const {
    return {disk.of(force) * disk.random, disk.of(torque) * disk.random_spin};
  }
};
static_assert(OneBodyDrive<ThermalBath>);

}  // namespace bagnold
