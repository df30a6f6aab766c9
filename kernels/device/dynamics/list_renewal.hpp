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
        excursion2(flown(position(i), motion(i).velocity, time_step), position(i), strain);
    if (moved2 > farthest.val) farthest = {moved2, i};
  }
};

}  // namespace bagnold
