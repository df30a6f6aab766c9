// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/pair_force.hpp"

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

}  // namespace bagnold
