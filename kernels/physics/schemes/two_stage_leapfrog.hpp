// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/lone_contact.hpp"
#include "kernels/physics/schemes/second_stage.hpp"

namespace bagnold {

/// Leapfrog with the damping in two stages. v belongs half a step before r:
///
///     a_i = f_i(r_n, v_-) dt/m_i                         first stage: all forces, once a step
///     b_i = sum_j f_dis(r_n, alpha (a_i - a_j)) dt/m_i   second stage: the damping of the changes
///     v_+ = v_- + a + b,   r_n+1 = r_n + v_+ dt
///
/// and the spins alike. To second order in the damping it is exp(-A dt) v_-, A v = -f_dis/m. The
/// share
///
///     alpha(z) = max{1/7, (z - 1 + e^-z) / z^2},   z: of the contact, see SecondStage
///
/// makes lone pairs relax by e^-z exactly and keeps the scheme stable: 1 - z + alpha z^2 stays
/// within (-1, 1] up to z = 7. Every contact reads the same starting data, so nothing depends on an
/// order of pairs. T: a number or pack; V: Vec2<T>, or T for the spin.
struct TwoStageLeapfrog {
  static constexpr std::string_view name = "two-stage-leapfrog";  ///< as in input and output

  /// Largest rate of damping that does not grow, times dt: |1 - y + y^2/7| <= 1.
  static constexpr Real largest_rate = 7;
  /// Largest frequency without damping, times dt: that of a leapfrog.
  static constexpr Real largest_frequency = 2;

  /// True if the scheme can step a law; and why it cannot step others.
  template <ContactLaw Law>
  static constexpr bool can_step = TwoStageLaw<Law>;
  static constexpr std::string_view cannot_step =
      "damping is not linear in the velocity, or neither normal nor isotropic and without spins";

  /// Rule for dt, [tau_e]: min{0.2, 0.2 Q} where disks rotate, otherwise min{0.2, 0.5 Q}, with Q
  /// over the larger damping constant in units of 1/Q. Biases are below 1% (docs/accuracy.md).
  template <TwoStageLaw Law>
  static Real time_step(DampingInput const& input) {
    Law const at_one = Law::make({1, input.normal, input.tangential});
    Real const damping = std::max(at_one.normal_damping(), at_one.tangential_damping());
    return std::min(0.2, (Law::rotates ? 0.2 : 0.5) * input.elasticity / damping);
  }

  /// alpha(z), by its series where the difference cancels.
  static Real share(Real z) {
    Real const exact =
        z < Real(1e-3) ? Real(0.5) - z / 6 + z * z / 24 : (z + std::expm1(-z)) / (z * z);
    return exact > Real(1) / 7 ? exact : Real(1) / 7;
  }

  /// a from the force of the first stage.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V change(V const& force, T const& per_mass) {
    return per_mass * force;
  }

  /// v_+ from v_-, a and the force of the second stage.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V velocity(V const& before, V const& change, V const& second,
                                                T const& per_mass) {
    return before + multiply_add(per_mass, second, change);
  }

  /// v_+ of a disk of a lone pair, from the sum of the forces of both stages.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V velocity_of_pair(V const& before, V const& both,
                                                        T const& per_mass) {
    return kicked(before, both, per_mass);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V position(V const& position, V const& after,
                                                T const& time_step) {
    return flown(position, after, time_step);
  }

  /// Step of two disks that touch no other.
  static RelativeMotion step(RelativeMotion const& q, LoneContact const& contact, Real dt) {
    Real const first = change(contact.acceleration(q), dt);
    LoneContact const damping{0, contact.damping, contact.opens};
    Real const changed = share(contact.damping * dt) * first;
    Real const after = velocity(q.v, first, damping.acceleration({q.x, changed}), dt);
    return {position(q.x, after, dt), after};
  }
};
static_assert(TwoStageScheme<TwoStageLeapfrog>);

}  // namespace bagnold
