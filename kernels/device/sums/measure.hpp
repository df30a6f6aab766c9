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

/// Disks whose parts are added in their order; such blocks are added in order afterwards. So the
/// result does not depend on threads.
inline constexpr std::uint32_t measured_block = 64;

template <class Forces, class Space>
struct MeasureBlock {
  Forces forces;
  Kokkos::View<Sums<Forces::rotates>*, Space> block_sums;  ///< [ceil(N / measured_block)]

  KOKKOS_FUNCTION void operator()(std::int64_t block) const {
    Sums<Forces::rotates> sums;
    auto const count = static_cast<std::int64_t>(forces.now().position.extent(0));
    std::int64_t const begin = block * measured_block, full = begin + measured_block;
    for (std::int64_t i = begin; i < (full < count ? full : count); ++i)
      sums += MeasureDisk<Forces>{forces}(static_cast<std::uint32_t>(i));
    block_sums(block) = sums;
  }
};

}  // namespace bagnold
