// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Share of the damping of the changes that acts in the second stage of a scheme: its share(z) of
///
///     z = N k_d dt (1/m_i + 1/m_j),
///
/// and for the tangent of disks that roll of tangential_mobility times that z. N: number of
/// contacts of the disk, of the two, that has more.
struct SecondStage {
  static constexpr int most = 8;     ///< N beyond it counts as it
  static constexpr int classes = 3;  ///< small-small, small-big, big-big
  Real normal[classes][most];        ///< by index(N)
  Real tangential[classes][most];    ///< by index(N)

  KOKKOS_FUNCTION static constexpr int index(int contacts) {
    return contacts < most ? contacts : 0;
  }

  template <TwoStageScheme Scheme, TwoStageLaw Law>
  static SecondStage of(Law const& law, SpeciesTable const& table, Real time_step) {
    SecondStage shares;
    for (int c = 0; c < classes; ++c) {
      Species const a = c == 2, b = c != 0;
      Real const per_force = time_step * (table.inverse_mass[a] + table.inverse_mass[b]);
      for (int n = 1; n <= most; ++n) {
        Real const z = n * per_force;
        shares.normal[c][n % most] = Scheme::share(law.normal_damping() * z);
        shares.tangential[c][n % most] =
            Scheme::share(law.tangential_damping() * z * tangential_mobility(Law::rotates));
      }
    }
    return shares;
  }
};

/// Velocity at a contact whose damping is added in the second stage. change: of v_i - v_j, at the
/// point of contact if the law rotates.
template <TwoStageLaw Law, class T>
KOKKOS_FORCEINLINE_FUNCTION Vec2<T> second_stage_velocity(Vec2<T> const& change,
                                                          Vec2<T> const& normal,
                                                          T const& share_normal,
                                                          T const& share_tangential) {
  if constexpr (Law::rotates)
    return share_tangential * change +
           ((share_normal - share_tangential) * dot(change, normal)) * normal;
  else
    return share_normal * change;  // CD: one and the same share; CD_n: no force along the tangent
}

/// Contact in the second stage: its velocity is the share of the change that is damped. Its
/// arguments: see make_contact and second_stage_velocity.
template <TwoStageLaw Law, class T>
KOKKOS_FORCEINLINE_FUNCTION Contact<T> second_stage_contact(
    Vec2<T> const& separation, T const& distance2, T const& inverse_distance, Vec2<T> const& change,
    T const& share_normal, T const& share_tangential) {
  Contact<T> contact = make_contact(separation, distance2, inverse_distance);
  contact.velocity =
      second_stage_velocity<Law>(change, contact.normal, share_normal, share_tangential);
  return contact;
}

/// Forces of both stages of a pair together. Observers see the velocity after half of the change by
/// the first stage. second: the contact in the second stage; velocity: at the contact before the
/// step.
template <TwoStageLaw Law, class Repulsion, class T>
KOKKOS_FORCEINLINE_FUNCTION PairForce<T> force_of_both_stages(
    Law const& law, Repulsion const& repulsion, Vec2<T> const& separation, Contact<T> const& second,
    Vec2<T> const& velocity, Vec2<T> const& change) {
  Contact<T> both = second;
  both.velocity = second.velocity + velocity;
  return force_of_contact(law, repulsion, separation, both, velocity + T(0.5) * change);
}

/// Change of the velocity at the contact of a lone pair in a step, by a force on i and its opposite
/// on j, with their torques.
///
/// torque: over the diameter; per_force: dt (1/m_i + 1/m_j); per_torque: dt (d_i^2/I_i +
/// d_j^2/I_j).
template <ContactLaw Law, class T>
KOKKOS_FORCEINLINE_FUNCTION Vec2<T> change_of_pair(Vec2<T> const& force,
                                                   T const& torque_per_diameter,
                                                   Vec2<T> const& separation,
                                                   T const& inverse_distance, T const& per_force,
                                                   T const& per_torque) {
  Vec2<T> change = per_force * force;
  if constexpr (Law::rotates)
    change = change - (T(0.5) * inverse_distance * per_torque * torque_per_diameter) *
                          perpendicular(separation);
  return change;
}

}  // namespace bagnold
