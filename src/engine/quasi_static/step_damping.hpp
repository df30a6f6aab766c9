// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"

namespace bagnold::quasi_static {

/// Damping of one contact in a long step, with a share for each direction:
///
///     f_dis = -s k_n (v . n) n - s_t k_t [v - (v . n) n]
///
/// s: share of the step's path along the normal that lies within contact, so that the force grows
/// from nothing as a contact closes, and has a potential, convex in the velocities; s_t: 1 where
/// the disks touched when the step began, else 0. With an s_t that follows the new positions, the
/// force would jump, and Newton's iterations would not converge.
template <bool Rotates>
struct StepDamping {
  static constexpr bool rotates = Rotates;
  Real normal;      ///< s k_n, [m / tau_e]
  Real tangential;  ///< s_t k_t, [m / tau_e]

  Vec2<Real> dissipative_force(Contact<Real> const& c) const {
    Vec2<Real> const along = dot(c.velocity, c.normal) * c.normal;
    return (-normal) * along - tangential * (c.velocity - along);
  }
};
static_assert(PairLaw<StepDamping<true>>);

/// s, from the overlaps d_ij - r_ij before and after the step; 0 if the disks are apart at both.
inline Real path_in_contact(Real before, Real after) {
  if (before > 0 && after > 0) return 1;
  if (after > 0) return after / (after - before);
  return before > 0 ? before / (before - after) : 0;
}

}  // namespace bagnold::quasi_static
