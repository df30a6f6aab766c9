// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/disk_views.hpp"
#include "kernels/device/dynamics/implicit_steps.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/device/dynamics/predict_correct.hpp"
#include "kernels/device/dynamics/two_stages.hpp"
#include "kernels/device/loops.hpp"

namespace bagnold {

/// One system and its step, by launches or in a team: Loops. What counts steps, keeps the box and
/// builds lists stands around it.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
struct SteppedSystem {
  static constexpr bool rotates = Law::rotates;
  using Views = DiskViews<rotates, Space, Scheme>;
  using Forces = ContactForces<Law, Repulsion, Space>;
  using Step = DeviceStep<Scheme>;

  Views disks;
  SpeciesTable table;
  Law law;
  Real time_step;  ///< dt, [tau_e]

  /// box: at the time of the disks.
  KOKKOS_FUNCTION Forces forces(ShearedBox const& box) const {
    return forces(box, disks.position, disks.motion);
  }
  KOKKOS_FUNCTION Forces forces(ShearedBox const& box,
                                typename Views::template Row<Vec2<Real>> const& position,
                                typename Views::template Row<Motion<rotates>> const& motion) const {
    return {position, motion, disks.species, disks.neighbors, table, box, law, Repulsion{}};
  }

  /// Forces of the configuration that sums are taken of, after begin_step().
  KOKKOS_FUNCTION auto measured_forces(ShearedBox const& box) const {
    return Step::measured_forces(*this, box);
  }

  /// Part of a step before its configuration is measured. Returns false if it cannot go on.
  template <class Loops>
  KOKKOS_FUNCTION bool begin_step(Loops const& loops, ShearedBox const& box) const {
    return Step::begin(*this, loops, box);
  }

  /// The rest of the step. next_box: a step later; strain, next_strain: since the build, a step and
  /// two steps later. Returns the largest |w|^2 of the disks then and a step after, [d_s^2];
  /// infinity where a number is not finite or an overlap beyond its limit.
  template <class Loops>
  KOKKOS_FUNCTION Real end_step(Loops const& loops, ShearedBox const& box,
                                ShearedBox const& next_box, Real strain, Real next_strain) {
    return Step::end(*this, loops, box, next_box, strain, next_strain);
  }

  template <class Loops>
  KOKKOS_FUNCTION void take_into_box(Loops const& loops, ShearedBox const& box) const {
    loops.for_all("dynamics::WrapDisks", disks.count(),
                  WrapDisks<rotates, Space>{box, disks.position, disks.motion, disks.at_build});
  }

  /// The largest |w|^2 of the next trial positions just after a build, and whose. strain: of a
  /// step.
  template <class Loops>
  KOKKOS_FUNCTION auto farthest_of_next_step(Loops const& loops, Real strain) const {
    using Farthest = Kokkos::MaxLoc<Real, std::int64_t>;
    typename Farthest::value_type farthest{};
    loops.reduce("dynamics::NextStep", disks.count(),
                 NextStep<rotates, Space>{disks.position, disks.motion, time_step, strain},
                 Farthest(farthest));
    return farthest;
  }
};

}  // namespace bagnold
