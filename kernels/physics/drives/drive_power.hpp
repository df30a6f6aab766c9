// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/drives/drive.hpp"

namespace bagnold {

/// Powers of a one-body force, summed over disks, [m d_s^2 / tau_e^3].
struct DrivePower {
  Real drag = 0;  ///< leaves the motion
  Real push = 0;  ///< goes into it

  KOKKOS_FUNCTION DrivePower& operator+=(DrivePower const& other) {
    drag += other.drag;
    push += other.push;
    return *this;
  }
};

/// Power of a force on the motion relative to the mean flow and on the rotation:
///
///     f . (v - u) + torque thetadot
///
/// so that d(kinetic + elastic)/dt = sigma gammadot L_x L_y - dissipation + the sum of it.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T power_of(Push<T> const& push, DrivenDisk<T> const& disk,
                                       Real strain_rate) {
  return dot(push.force, disk.velocity) + push.torque * (disk.spin - T(strain_rate / 2));
}

}  // namespace bagnold
