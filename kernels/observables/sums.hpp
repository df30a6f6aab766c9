// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/dynamics/contact_forces.hpp"

namespace bagnold {

/// What is summed over a configuration: everything later observables are functions of.
///
/// Pair sums run over pairs once, p_ab L^2 = sum f_a r_b (P1 Eqs. 9-10, P2 Eqs. 12-13); the
/// dissipative one is not symmetric in model CD. dv = v - gammadot y x^.
struct SumColumns {
  enum : int {
    elastic_xx,      ///< sum f_x r_x, [m d_s^2 / tau_e^2]
    elastic_xy,
    elastic_yy,
    dissipative_xx,
    dissipative_xy,  ///< sum f_x r_y: the one that closes the energy balance
    dissipative_yx,
    dissipative_yy,
    kinetic_xx,      ///< sum m dv_x dv_x, [m d_s^2 / tau_e^2]
    kinetic_xy,
    kinetic_yy,
    contacts,        ///< disks touched by a disk, summed over disks: twice the pairs
    velocity_x2,     ///< sum dv_x^2, not weighted by mass, P2 Eq. (35), [d_s^2 / tau_e^2]
    velocity_y2,     ///< sum v_y^2, P2 Eq. (36)
    count,           ///< columns of a law that does not rotate
    spin = count,    ///< sum thetadot, [1 / tau_e]
    spin2,           ///< sum thetadot^2, P2 Eq. (29)
    count_rotating
  };
};

template <bool Rotates>
struct Sums {
  static constexpr int columns = Rotates ? SumColumns::count_rotating : SumColumns::count;
  Real value[columns] = {};
};

/// Adds one disk's half of each of its pairs.
template <bool Rotates>
struct PairSums {
  Sums<Rotates>& sums;

  KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) const {
    auto& s = sums.value;
    Vec2<Real> const half = Real(0.5) * pair.separation;
    s[SumColumns::elastic_xx] += pair.elastic.x * half.x;
    s[SumColumns::elastic_xy] += pair.elastic.x * half.y;
    s[SumColumns::elastic_yy] += pair.elastic.y * half.y;
    s[SumColumns::dissipative_xx] += pair.dissipative.x * half.x;
    s[SumColumns::dissipative_xy] += pair.dissipative.x * half.y;
    s[SumColumns::dissipative_yx] += pair.dissipative.y * half.x;
    s[SumColumns::dissipative_yy] += pair.dissipative.y * half.y;
    s[SumColumns::contacts] += 1;
  }
};

/// Sums over blocks of consecutive disks, each in order; the blocks are added in order afterwards.
/// So the result does not depend on threads.
template <ContactLaw Law, class Repulsion, class Space, class Pairs>
struct MeasureBlock {
  static constexpr std::int64_t disks = 64;  ///< in a block

  ContactForces<Law, Repulsion, Space> forces;
  Pairs pairs;  ///< pairs(i, observer), for each disk
  Kokkos::View<Sums<Law::rotates>*, Space> block_sums;  ///< [ceil(N / disks)]

  KOKKOS_FUNCTION void operator()(std::int64_t block) const {
    Sums<Law::rotates> sums;
    std::int64_t const count = forces.position.extent(0);
    std::int64_t const end = (block + 1) * disks < count ? (block + 1) * disks : count;
    for (std::int64_t i = block * disks; i < end; ++i) {
      pairs(static_cast<std::uint32_t>(i), PairSums<Law::rotates>{sums});
      add_disk(sums.value, i);
    }
    block_sums(block) = sums;
  }

 private:
  KOKKOS_FUNCTION void add_disk(Real* s, std::int64_t i) const {
    Real const mass = 1 / forces.table.inverse_mass[forces.species(i)];
    auto const motion = forces.motion(i);
    Real const vx = motion.velocity.x - forces.box.strain_rate * forces.position(i).y;
    Real const vy = motion.velocity.y;
    s[SumColumns::kinetic_xx] += mass * vx * vx;
    s[SumColumns::kinetic_xy] += mass * vx * vy;
    s[SumColumns::kinetic_yy] += mass * vy * vy;
    s[SumColumns::velocity_x2] += vx * vx;
    s[SumColumns::velocity_y2] += vy * vy;
    if constexpr (Law::rotates) {
      s[SumColumns::spin] += motion.spin;
      s[SumColumns::spin2] += motion.spin * motion.spin;
    }
  }
};

}  // namespace bagnold
