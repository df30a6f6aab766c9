// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"

namespace bagnold {

/// Damping linear in the velocity, with one constant: base of a law.
///
///     f_dis = -k_d (v . n) n         along_tangent = false
///     f_dis = -k_d v                 along_tangent = true
///
/// v: velocity of i against j at the point of contact if `spins`, else of the centres. Force on i
/// from j, [m d_s / tau_e^2].
template <bool along_tangent, bool spins>
struct LinearDamping {
  static constexpr bool rotates = spins;
  static constexpr bool linear = true;
  static constexpr bool one_constant = true;
  static constexpr bool separate_constants = false;
  Real damping;  ///< k_d, [m / tau_e]; 1/Q in reduced units

  Real normal_damping() const { return damping; }
  Real tangential_damping() const { return along_tangent ? damping : 0; }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    if constexpr (along_tangent)
      return T(-damping) * c.velocity;
    else
      return T(-damping) * dot(c.velocity, c.normal) * c.normal;
  }
};

/// Damping linear in the velocity, with a constant for each direction: base of a law.
///
///     f_dis = -k_n (v . n) n - k_t [v - (v . n) n]
template <bool spins>
struct SeparateDamping {
  static constexpr bool rotates = spins;
  static constexpr bool linear = true;
  static constexpr bool one_constant = false;
  static constexpr bool separate_constants = true;
  Real damping_normal;      ///< k_d^(n), [m / tau_e]
  Real damping_tangential;  ///< k_d^(t), [m / tau_e]

  Real normal_damping() const { return damping_normal; }
  Real tangential_damping() const { return damping_tangential; }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const normal_part = T(damping_tangential - damping_normal) * dot(c.velocity, c.normal);
    return normal_part * c.normal - T(damping_tangential) * c.velocity;
  }
};

}  // namespace bagnold
