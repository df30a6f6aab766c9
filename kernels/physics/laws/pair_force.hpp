// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/math.hpp"

namespace bagnold {

/// Forces of a pair in contact on i, and where they act: the argument of observers of the pair
/// loops.
template <class T>
struct PairForce {
  Vec2<T> separation;   ///< r_ij = r_i - r_j, nearest image, [d_s]
  Vec2<T> elastic;      ///< on i from j, [m d_s / tau_e^2]
  Vec2<T> dissipative;  ///< on i from j, [m d_s / tau_e^2]
  T relative_overlap;   ///< 1 - r_ij / d_ij
  Vec2<T> velocity;     ///< of i against j where the dissipative force acts, [d_s / tau_e]

  /// Power that the dissipative force takes out of the motion, -f_dis . v, [m d_s^2 / tau_e^3].
  KOKKOS_FUNCTION T dissipation() const { return -dot(dissipative, velocity); }

  /// Torque on i over d_i, and on j over d_j, [m d_s / tau_e^2]:
  /// -1/(d_i + d_j) r_ij x f_dis, P2 Eq. (7).
  KOKKOS_FUNCTION T torque_per_diameter(T const& inverse_distance) const {
    return T(-0.5) * inverse_distance * cross(separation, dissipative);
  }
};

/// Two disks in contact, without their velocity. distance2 = r_ij^2; inverse_distance: 1/d_ij.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION Contact<T> make_contact(Vec2<T> const& separation, T const& distance2,
                                                    T const& inverse_distance) {
  using math::inverse_sqrt;  // packs bring their own
  T const inverse = inverse_sqrt(distance2);
  Contact<T> contact;
  contact.normal = inverse * separation;
  contact.relative_overlap = T(1) - distance2 * inverse * inverse_distance;
  contact.inverse_distance = inverse_distance;
  return contact;
}

/// Velocity of i relative to j in the law: of the centres, or at the point of contact.
///
///     v_i^C - v_j^C = v_ij - (thetadot_i d_i + thetadot_j d_j)/(d_i + d_j) z^ x r_ij   P2 Eq. (6)
///
/// velocity: v_i - v_j with the shear of the image; spins: thetadot_i d_i + thetadot_j d_j, [d_s /
/// tau_e], ignored if the law does not rotate. Changes of both may be given instead.
template <PairLaw Law, class T>
KOKKOS_FORCEINLINE_FUNCTION Vec2<T> velocity_at_contact(Vec2<T> const& velocity,
                                                        Vec2<T> const& separation,
                                                        T const& inverse_distance, T const& spins) {
  if constexpr (Law::rotates)
    return velocity - (T(0.5) * inverse_distance * spins) * perpendicular(separation);
  else
    return velocity;
}

/// Forces of a contact whose damping acts at contact.velocity. velocity: what observers see.
template <PairLaw Law, class Repulsion, class T>
KOKKOS_FORCEINLINE_FUNCTION PairForce<T> force_of_contact(Law const& law,
                                                          Repulsion const& repulsion,
                                                          Vec2<T> const& separation,
                                                          Contact<T> const& contact,
                                                          Vec2<T> const& velocity) {
  return {separation, repulsion.magnitude(contact) * contact.normal, law.dissipative_force(contact),
          contact.relative_overlap, velocity};
}

/// Force of a pair that touches, for one pair or a pack of pairs. Arguments: see make_contact and
/// velocity_at_contact.
template <PairLaw Law, class Repulsion, class T>
KOKKOS_FORCEINLINE_FUNCTION PairForce<T> pair_force(Law const& law, Repulsion const& repulsion,
                                                    Vec2<T> const& separation, T const& distance2,
                                                    Vec2<T> const& velocity,
                                                    T const& inverse_distance, T const& spins) {
  Contact<T> contact = make_contact(separation, distance2, inverse_distance);
  contact.velocity = velocity_at_contact<Law>(velocity, separation, inverse_distance, spins);
  return force_of_contact(law, repulsion, separation, contact, contact.velocity);
}

}  // namespace bagnold
