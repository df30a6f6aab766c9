// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/drives/drive.hpp"

namespace bagnold {

/// What a step of a predict-correct scheme keeps of the change v~ - v of a disk to its trial state,
/// exactly where nothing but the drive acts. With z = zeta dt/m, v~ - v = t (f dt/m - z v) and
/// gain(z), t of SchemeOnDisk:
///
///     v_1 - v = gain (v~ - v)/t,
///     the drag is that of the velocity v + (1 - gain)/(z t) (v~ - v),
///
/// so that powers at (v + v_1)/2 are what the motion gains.
class TrialShares {
 public:
  explicit TrialShares(DriveInput const& input) {
    auto const& table = input.table;
    auto const of = [&](Species s) {
      return shares(input.scheme, input.drag * input.time_step * table.inverse_mass[s]);
    };
    auto const of_spin = [&](Species s) {
      Real const zeta = spin_drag(input.drag, table.diameter[s]);
      return shares(input.scheme, zeta * input.time_step * table.inverse_inertia[s]);
    };
    drag_ = {of(0).drag, of(1).drag};
    halfway_ = {of(0).halfway, of(1).halfway};
    spin_drag_ = {of_spin(0).drag, of_spin(1).drag};
    spin_halfway_ = {of_spin(0).halfway, of_spin(1).halfway};
  }

  /// `disk` with the velocities whose drag acts in the step; trial: that at the trial state.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION DrivenDisk<T> dragged(DrivenDisk<T> const& disk,
                                                    DrivenDisk<T> const& trial) const {
    return between(disk, trial, disk.of(drag_), disk.of(spin_drag_));
  }

  /// `disk` with the velocities halfway through the step.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION DrivenDisk<T> halfway(DrivenDisk<T> const& disk,
                                                    DrivenDisk<T> const& trial) const {
    return between(disk, trial, disk.of(halfway_), disk.of(spin_halfway_));
  }

 private:
  struct Shares {
    Real drag, halfway;
  };

  static Shares shares(SchemeOnDisk const& scheme, Real z) {
    Real const gain = scheme.gain(z);
    return {z == 0 ? 0 : (1 - gain) / (z * scheme.trial), gain / (2 * scheme.trial)};
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static DrivenDisk<T> between(DrivenDisk<T> disk,
                                                           DrivenDisk<T> const& trial,
                                                           T const& share, T const& spin_share) {
    disk.velocity = disk.velocity + share * (trial.velocity - disk.velocity);
    disk.spin = disk.spin + spin_share * (trial.spin - disk.spin);
    return disk;
  }

  PerSpecies drag_{}, halfway_{}, spin_drag_{}, spin_halfway_{};
};

}  // namespace bagnold
