// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/physics/box/list_criterion.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"

namespace bagnold {

/// Takes a disk into the box, before a list build from there.
template <bool Rotates, class Space>
struct WrapDisks {
  ShearedBox box;
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> at_build;

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    wrap(box, position(i), motion(i).velocity.x);
    at_build(i) = position(i);
  }
};

/// Reduces (MaxLoc) the largest |w|^2 of the next trial positions, just after a build.
template <bool Rotates, class Space>
struct NextStep {
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Real time_step;  ///< dt, [tau_e]
  Real strain;     ///< in one step

  KOKKOS_FUNCTION void operator()(std::int64_t i,
                                  Kokkos::ValLocScalar<Real, std::int64_t>& farthest) const {
    Real const moved2 =
        nonaffine2(flown(position(i), motion(i).velocity, time_step), position(i), strain);
    if (moved2 > farthest.val) farthest = {moved2, i};
  }
};

/// Keeps the largest |w|^2 of a disk now and a step later; infinity where it is NaN, or not
/// sound.
KOKKOS_INLINE_FUNCTION void keep_largest(Real& largest, Real now2, Real next2, bool sound) {
  Real value = now2 > next2 ? now2 : next2;
  if (!(sound && value < Kokkos::reduction_identity<Real>::min() && now2 == now2))
    value = Kokkos::reduction_identity<Real>::min();
  if (value > largest) largest = value;
}

/// Reduces (Max) the largest |w|^2 now and a step later, as steps do on their way.
template <bool Rotates, class Space>
struct Farthest {
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> at_build;
  Real time_step;                ///< dt, [tau_e]
  Real strain_since_build;       ///< now
  Real next_strain_since_build;  ///< a step later

  KOKKOS_FUNCTION void operator()(std::int64_t i, Real& largest) const {
    keep_largest(largest, nonaffine2(position(i), at_build(i), strain_since_build),
                 nonaffine2(flown(position(i), motion(i).velocity, time_step), at_build(i),
                            next_strain_since_build),
                 true);
  }
};

}  // namespace bagnold
