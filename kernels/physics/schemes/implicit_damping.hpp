// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/lone_contact.hpp"

namespace bagnold {

/// Leapfrog with implicit damping, for dense flows. v belongs half a step before r:
///
///     a_i = f_i(r_n, v_-) dt/m_i                      all forces, once a step
///     w_i - (dt/m_i) f_dis,i(r_n, w) = a_i            solved by a fixed number of iterations
///     v_+ = v_- + w,   r_n+1 = r_n + v_+ dt
///
/// and the spins alike: the elastic force is that at r_n, the damping that of v_+. It holds one
/// mode stable where dt (dt - 2 c/omega^2) < 4/omega^2, c: its damping rate; so far longer steps
/// than explicit damping in flows whose motions are overdamped, and only there are they right.
struct ImplicitDamping {
  static constexpr std::string_view name = "implicit-damping";  ///< as in input and output

  static constexpr Real theta = 1;  ///< weight of the new velocities in the damping

  /// Terms of the Chebyshev solution for w. With spins the eigenvalues of the damping extend twice
  /// as far.
  static constexpr int terms(bool rotates) { return rotates ? 5 : 3; }

  /// Lift s of its polynomial. Of a mode with y = c dt the terms leave the part e of w, and a step
  /// is stable where (1 - e) omega^2 dt^2 < 4 + 2 y (1 + e): a part below 0 takes from what damping
  /// holds, one above 0 adds to it and is caught up in the next step, as a steady motion needs no
  /// w. So longer steps are stable, or fewer terms are enough.
  static constexpr Real lift = 0.5;

  /// Least tangential damping relative to the normal one: below it inertia always matters along
  /// contacts.
  static constexpr Real least_tangential_share = 0.3;

  /// Largest rate of damping that does not grow, times dt: none, as the factor of a step is 1/(1 +
  /// y).
  static constexpr Real largest_rate = std::numeric_limits<Real>::infinity();
  /// Largest frequency without damping, times dt: that of a leapfrog.
  static constexpr Real largest_frequency = 2;

  /// Largest stable dt of a mode x'' = -omega^2 x - c x': omega^2 dt^2 = 4 + 2 c dt. [tau_e]
  static Real largest_time_step(Real rate, Real frequency2) {
    return (rate + std::sqrt(rate * rate + 4 * frequency2)) / frequency2;
  }

  /// True if the scheme can step a law; and why it cannot step others.
  template <ContactLaw Law>
  static constexpr bool can_step = LinearLaw<Law>;
  static constexpr std::string_view cannot_step = "damping is not linear in the velocity";

  /// Rule for dt, [tau_e]: 1.6 min{1, Q^-0.3}; where disks roll 1.8 min{1, Q^-1/3}, 1.4 for 1.8
  /// where sliding contacts are damped less than normals, so that inertia matters more. Q is over
  /// the normal damping constant in units of 1/Q, as that alone holds the stiff motions along
  /// normals; 0.2 where these are undamped, or sliding contacts (nearly), so that inertia always
  /// matters. Biases in Newtonian flow are below 0.5% (docs/long_steps.md, "Implicit damping").
  template <LinearLaw Law>
  static Real time_step(DampingInput const& input) {
    Law const at_one = Law::make({1, input.normal, input.tangential});
    Real const normal = at_one.normal_damping(), tangential = at_one.tangential_damping();
    if (!(normal > 0) || tangential < least_tangential_share * normal) return 0.2;
    Real const rolling = tangential < normal ? 1.4 : 1.8;
    Real const longest = Law::rotates ? rolling : 1.6, power = Law::rotates ? 1.0 / 3 : 0.3;
    return longest * std::min(1.0, std::pow(input.elasticity / normal, -power));
  }

  /// a from the force.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V change(V const& force, T const& per_mass) {
    return per_mass * force;
  }

  /// v_+ from v_- and w.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V velocity(V const& before, V const& change) {
    return before + change;
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V position(V const& position, V const& after,
                                                T const& time_step) {
    return flown(position, after, time_step);
  }

  /// Step of two disks that touch no other, with the equation solved exactly.
  static RelativeMotion step(RelativeMotion const& q, LoneContact const& contact, Real dt) {
    Real const damping = contact.acts(q) ? theta * contact.damping * dt : Real(0);
    Real const after = velocity(q.v, change(contact.acceleration(q), dt) / (1 + damping));
    return {position(q.x, after, dt), after};
  }
};
static_assert(ImplicitScheme<ImplicitDamping>);

}  // namespace bagnold
