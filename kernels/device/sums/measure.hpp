// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Adds one disk's part of the sums over pairs, and of their power.
template <class Forces, bool Rotates>
KOKKOS_FUNCTION void add_pairs(Forces const& forces, std::uint32_t i, Sums<Rotates>& sums) {
  auto const power = forces.power(i, PairSums<Rotates>{sums});
  sums.value[SumColumns::dissipation] += power.dissipation;
  if constexpr (Rotates) sums.value[SumColumns::torque_power] += power.torque;
}

/// One disk's part of the sums. Forces: ContactForces, or what stands for them in a scheme's step.
template <class Forces>
struct MeasureDisk {
  Forces forces;

  KOKKOS_FUNCTION auto operator()(std::uint32_t i) const {
    auto const& now = forces.now();
    Sums<Forces::rotates> sums;
    add_pairs(forces, i, sums);
    auto const motion = now.motion(i);
    Real const mass = 1 / now.table.inverse_mass[now.species(i)];
    Real const ux = peculiar_x(motion.velocity.x, now.position(i).y, now.box.strain_rate);
    add_motion(sums.value, mass, ux, motion.velocity.y);
    if constexpr (Forces::rotates) add_spin(sums.value, motion.spin);
    return sums;
  }
};

template <class Forces, class Space>
struct MeasureDisks {
  Forces forces;
  Kokkos::View<Sums<Forces::rotates>*, Space> of_disk;  ///< [N], by rank
  Kokkos::View<std::uint32_t*, Space> rank;             ///< [N], or empty: by index

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    auto const place = rank.extent(0) == 0 ? i : static_cast<std::int64_t>(rank(i));
    of_disk(place) = MeasureDisk<Forces>{forces}(static_cast<std::uint32_t>(i));
  }
};

}  // namespace bagnold
