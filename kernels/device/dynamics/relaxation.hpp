// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/device/neighbors/verlet_list.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"

namespace bagnold {

/// No damping between disks.
struct NoDissipation {
  static constexpr bool rotates = false;

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const&) const {
    return {};
  }
};

/// One iteration of overlap relaxation at rest: gradient descent with momentum on the elastic
/// energy (m = 1, a drag on every disk), v <- keep v + f dt, r <- r + v dt.
///
/// Local to a disk, so its bits do not depend on threads. Reduces (Max) the largest |w|^2.
template <class Space>
struct Relax {
  ContactForces<NoDissipation, HarmonicRepulsion, Space> forces;
  Kokkos::View<Motion<false>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> next_position;
  Kokkos::View<Vec2<Real>*, Space> at_build;

  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& largest) const {
    constexpr Real time_step = 0.3;  // below 2/omega_max, omega_max^2 about 10 at Z = 5
    constexpr Real keep = 0.9;       // share of the velocity kept
    auto const load = forces(i, NoObserver{});
    Vec2<Real> const velocity = keep * motion(i).velocity + time_step * load.force;
    Vec2<Real> const moved = forces.position(i) + time_step * velocity;
    motion(i).velocity = velocity;
    next_position(i) = moved;
    Real const moved2 = nonaffine2(moved, at_build(i), 0);
    if (!(moved2 <= largest)) largest = moved2;
  }
};

/// Reduces (MaxLoc) the largest relative overlap 1 - r_ij/d_ij of all contacts, and a disk that has
/// it; where nothing touches the value is that of an empty reduction, negative.
template <PairLaw Law, class Repulsion, class Space>
struct LargestOverlap {
  using Value = Kokkos::ValLocScalar<Real, std::int64_t>;

  struct DeepestOverlap {
    Real& largest;
    KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) const {
      if (pair.relative_overlap > largest) largest = pair.relative_overlap;
    }
  };

  ContactForces<Law, Repulsion, Space> forces;

  KOKKOS_FUNCTION void operator()(std::int64_t i, Value& deepest) const {
    Real largest = 0;
    forces(static_cast<std::uint32_t>(i), DeepestOverlap{largest});
    if (largest > deepest.val) deepest = {largest, i};
  }
};

}  // namespace bagnold
