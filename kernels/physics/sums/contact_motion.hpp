// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cmath>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Relative motion of the surfaces of two disks in contact, over gammadot d_s.
///
/// With t = z x r_ji/r_ij (P2 Eqs. 30-34): V_ij,T = V_ij . t, V_ij,N = V_ij . r_ji/r_ij (positive
/// where they approach), V^C_ij,T = V_ij,T + V^R_ij. The point of contact is that of P2 Eq. (6), so
///
///     V^R_ij = r_ij (d_i thetadot_i + d_j thetadot_j) / (d_i + d_j) / (gammadot d_s),
///
/// about half of P2 Eq. (31). All are the same for (j, i).
struct ContactVelocities {
  Real tangential = 0;  ///< V_ij,T
  Real rotational = 0;  ///< V^R_ij; 0 where disks do not rotate
  Real normal = 0;      ///< V_ij,N

  Real at_contact() const { return tangential + rotational; }  ///< V^C_ij,T
};

/// separation: r_ij, [d_s]; velocity: v_ij, [d_s/tau_e]; spin: (d_i thetadot_i + d_j thetadot_j) /
/// (d_i + d_j), [1/tau_e].
inline ContactVelocities contact_velocities(Vec2<Real> const& separation,
                                            Vec2<Real> const& velocity, Real spin,
                                            Real strain_rate) {
  Real const r = std::sqrt(dot(separation, separation));
  return {cross(velocity, separation) / r / strain_rate, r * spin / strain_rate,
          -dot(velocity, separation) / r / strain_rate};
}

/// Sums over pairs in contact, of V_T, V_R, V_N of ContactVelocities in [d_s / tau_e].
struct ContactMotion {
  enum : int {
    normal2,
    tangential2,
    rotational2,
    tangential_rotational,
    tangential_normal,
    rotational_normal,
    tangential,
    rotational,
    normal,
    contacts,
    count
  };
  static constexpr int columns = count;
  Real value[columns] = {};

  /// spin: as in contact_velocities().
  KOKKOS_FUNCTION void add(Real weight, Vec2<Real> const& separation, Vec2<Real> const& velocity,
                           Real spin) {
    Real const r2 = dot(separation, separation), along = dot(velocity, separation);
    Real const across = cross(velocity, separation), r = std::sqrt(r2);
    value[normal2] += weight * (along * along / r2);
    value[tangential2] += weight * (across * across / r2);
    value[rotational2] += weight * (r2 * spin * spin);
    value[tangential_rotational] += weight * (across * spin);
    value[tangential_normal] -= weight * (across * along / r2);
    value[rotational_normal] -= weight * (along * spin);
    value[tangential] += weight * (across / r);
    value[rotational] += weight * (r * spin);
    value[normal] -= weight * (along / r);
    value[contacts] += weight;
  }
  ContactMotion& operator+=(ContactMotion const& o) {
    for (int c = 0; c < count; ++c) value[c] += o.value[c];
    return *this;
  }
};

}  // namespace bagnold
