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
    dissipation,     ///< -sum f_dis . v over pairs: power that leaves the motion, [m d_s^2 / tau_e^3]
    kinetic_xx,      ///< sum m dv_x dv_x, [m d_s^2 / tau_e^2]
    kinetic_xy,
    kinetic_yy,
    contacts,        ///< disks touched by a disk, summed over disks: twice the pairs
    velocity_x2,     ///< sum dv_x^2, not weighted by mass, P2 Eq. (35), [d_s^2 / tau_e^2]
    velocity_y2,     ///< sum v_y^2, P2 Eq. (36)
    count,           ///< columns of a law that does not rotate
    spin = count,    ///< sum thetadot, [1 / tau_e]
    spin2,           ///< sum thetadot^2, P2 Eq. (29)
    torque_power,    ///< sum of torque times thetadot = -k_t sum v^C_T v^R over pairs, P2 Eqs. (32)-(33):
                     ///< power that goes into the rotation, [m d_s^2 / tau_e^3]
    count_rotating
  };
};

template <bool Rotates>
struct Sums {
  static constexpr int columns = Rotates ? SumColumns::count_rotating : SumColumns::count;
  Real value[columns] = {};

  KOKKOS_FUNCTION Sums& operator+=(Sums const& other) {
    for (int c = 0; c < columns; ++c) value[c] += other.value[c];
    return *this;
  }
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
    s[SumColumns::dissipation] += Real(0.5) * pair.dissipation();
    s[SumColumns::contacts] += 1;
  }
};

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
    Real* const s = sums.value;
    Real const mass = 1 / now.table.inverse_mass[now.species(i)];
    auto const motion = now.motion(i);
    Real const vx = motion.velocity.x - now.box.strain_rate * now.position(i).y;
    Real const vy = motion.velocity.y;
    s[SumColumns::kinetic_xx] = mass * vx * vx;
    s[SumColumns::kinetic_xy] = mass * vx * vy;
    s[SumColumns::kinetic_yy] = mass * vy * vy;
    s[SumColumns::velocity_x2] = vx * vx;
    s[SumColumns::velocity_y2] = vy * vy;
    if constexpr (Forces::rotates) {
      s[SumColumns::spin] = motion.spin;
      s[SumColumns::spin2] = motion.spin * motion.spin;
    }
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
