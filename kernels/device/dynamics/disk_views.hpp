// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/neighbor_rows.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Views that a step of a scheme needs for one system beside trial positions and motions: none,
/// unless the header of its form says otherwise.
template <bool Rotates, class Scheme, class Space>
struct StepViews {
  template <class Law>
  void allocate(Law const&, SpeciesTable const&, Real, std::size_t) {}
};

/// Views that a step of a scheme needs for many systems; none unless its form says otherwise.
template <bool Rotates, class Scheme, class Space>
struct StepTables {
  KOKKOS_FUNCTION StepViews<Rotates, Scheme, Space> of(std::size_t) const { return {}; }

  template <class Law>
  void allocate(Law const&, SpeciesTable const&, Real, std::size_t, std::size_t) {}
};

/// The disks of one system in memory.
template <bool Rotates, class Space, class Scheme>
struct DiskViews {
  template <class T>
  using Row = Kokkos::View<T*, Space>;

  Row<Vec2<Real>> position, trial_position, at_build;  ///< [N], [d_s]
  Row<Motion<Rotates>> motion, trial_motion;           ///< [N]
  Row<Species> species;                                ///< [N]
  NeighborRows<Space> neighbors;
  StepViews<Rotates, Scheme, Space> step;

  KOKKOS_FUNCTION std::int64_t count() const {
    return static_cast<std::int64_t>(position.extent(0));
  }
};

}  // namespace bagnold
