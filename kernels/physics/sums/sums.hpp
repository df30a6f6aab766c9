// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/multiply_add.hpp"

namespace bagnold {

/// Sums over a configuration, of which all observables are functions.
///
/// Pair sums run over pairs once, p_ab L_x L_y = sum f_a r_b (P1 Eqs. 9-10, P2 Eqs. 12-13); the
/// dissipative one is not symmetric in model CD. dv = v - gammadot y x^.
struct SumColumns {
  enum : int {
    elastic_xx,  ///< sum f_x r_x, [m d_s^2 / tau_e^2]
    elastic_xy,
    elastic_yy,
    dissipative_xx,
    dissipative_xy,  ///< sum f_x r_y: the one that closes the energy balance
    dissipative_yx,
    dissipative_yy,
    dissipation,  ///< -sum f_dis . v over pairs: power that leaves the motion, [m d_s^2 / tau_e^3]
    kinetic_xx,   ///< sum m dv_x dv_x, [m d_s^2 / tau_e^2]
    kinetic_xy,
    kinetic_yy,
    contacts,      ///< disks touched by a disk, summed over disks: twice the pairs
    velocity_x2,   ///< sum dv_x^2, not weighted by mass, P2 Eq. (35), [d_s^2 / tau_e^2]
    velocity_y2,   ///< sum v_y^2, P2 Eq. (36)
    count,         ///< columns of a law that does not rotate
    spin = count,  ///< sum thetadot, [1 / tau_e]
    spin2,         ///< sum thetadot^2, P2 Eq. (29)
    torque_power,  ///< sum of torque times thetadot = -k_t sum v^C_T v^R over pairs, P2 Eqs.
                   ///< (32)-(33): power that goes into the rotation, [m d_s^2 / tau_e^3]
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

/// Number of columns of pairs: those before kinetic_xx.
inline constexpr int pair_columns = SumColumns::kinetic_xx;

template <class T>
struct PairColumns {
  T value[pair_columns];
};

template <class T>
KOKKOS_FORCEINLINE_FUNCTION PairColumns<T> columns_of(PairForce<T> const& pair) {
  using C = SumColumns;
  auto const &r = pair.separation, &elastic = pair.elastic, &dissipative = pair.dissipative;
  PairColumns<T> of;
  of.value[C::elastic_xx] = elastic.x * r.x;
  of.value[C::elastic_xy] = elastic.x * r.y;
  of.value[C::elastic_yy] = elastic.y * r.y;
  of.value[C::dissipative_xx] = dissipative.x * r.x;
  of.value[C::dissipative_xy] = dissipative.x * r.y;
  of.value[C::dissipative_yx] = dissipative.y * r.x;
  of.value[C::dissipative_yy] = dissipative.y * r.y;
  of.value[C::dissipation] = pair.dissipation();
  return of;
}

/// Adds a pair, or a share `weight` of it. to: indexed by column.
template <class Columns>
KOKKOS_FORCEINLINE_FUNCTION void add_pair(Columns& to, PairForce<Real> const& pair, Real weight) {
  auto const of = columns_of(pair);
  for (int c = 0; c < pair_columns; ++c) to[c] += weight * of.value[c];
  to[SumColumns::contacts] += 2 * weight;
}

/// v_x - gammadot y, of one disk at y.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T peculiar_x(T const& velocity_x, T const& y, Real strain_rate) {
  return multiply_add(T(-strain_rate), y, velocity_x);
}

/// Adds the motion of a disk: u = v - gammadot y x^. to: indexed by column. Numbers: of one disk,
/// packs, or polynomials in time (in_time.hpp).
template <class Columns, class Mass, class X, class Y>
KOKKOS_FORCEINLINE_FUNCTION void add_motion(Columns& to, Mass const& mass, X const& ux,
                                            Y const& uy) {
  to[SumColumns::kinetic_xx] += mass * ux * ux;
  to[SumColumns::kinetic_xy] += mass * ux * uy;
  to[SumColumns::kinetic_yy] += mass * uy * uy;
  to[SumColumns::velocity_x2] += ux * ux;
  to[SumColumns::velocity_y2] += uy * uy;
}

/// Adds the spin of a disk, for a law that rotates.
template <class Columns, class T>
KOKKOS_FORCEINLINE_FUNCTION void add_spin(Columns& to, T const& spin) {
  to[SumColumns::spin] += spin;
  to[SumColumns::spin2] += spin * spin;
}

/// Adds one disk's half of each of its pairs.
template <bool Rotates>
struct PairSums {
  Sums<Rotates>& sums;

  KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) const {
    add_pair(sums.value, pair, Real(0.5));
  }
};

}  // namespace bagnold
