// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/lone_contact.hpp"

namespace bagnold {

/// The papers' scheme, P2 Eqs. (21)-(24), the spin like the velocity:
///
///     v~_1 = v_0 + f(r_0, v_0) dt/m,             r~_1 = r_0 + v_0 dt
///     v_1 = (v_0 + v~_1)/2 + f(r~_1, v~_1) dt/2m,   r_1 = r_0 + (v_0 + v_1) dt/2
///
/// where (v_0 + v~_1)/2 is v_0 + f(r_0, v_0) dt/2m. T: a number or pack; V: Vec2<T>, or T for the
/// spin.
struct ModifiedVelocityVerlet {
  static constexpr std::string_view name = "modified-velocity-verlet";  ///< as in input and output

  /// Largest rate of damping that does not grow, times dt: |1 - y + y^2/2| <= 1.
  static constexpr Real largest_rate = 2;
  /// Largest frequency without damping, times dt: that of velocity Verlet.
  static constexpr Real largest_frequency = 2;

  /// True if the scheme can step a law: it steps all.
  template <ContactLaw Law>
  static constexpr bool can_step = true;

  /// Rule for dt, [tau_e]: that of the papers.
  template <ContactLaw Law>
  static Real time_step(DampingInput const& input) {
    return Law::paper_time_step(input.elasticity);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V trial_velocity(V const& velocity, V const& force,
                                                      T const& per_mass) {
    return kicked(velocity, force, per_mass);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V trial_position(V const& position, V const& velocity,
                                                      T const& time_step) {
    return flown(position, velocity, time_step);
  }

  /// v_1 from v_0 and v~_1. force: at the trial state; half_per_mass: dt/2m.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V velocity(V const& before, V const& trial, V const& force,
                                                T const& half_per_mass) {
    return kicked(T(0.5) * (before + trial), force, half_per_mass);
  }

  /// r_1 from r_0, v_0 and v_1.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V position(V const& position, V const& before, V const& after,
                                                T const& half_time_step) {
    return flown(position, before + after, half_time_step);
  }

  /// Step of two disks that touch no other.
  static RelativeMotion step(RelativeMotion const& q, LoneContact const& contact, Real dt) {
    RelativeMotion const trial{trial_position(q.x, q.v, dt),
                               trial_velocity(q.v, contact.acceleration(q), dt)};
    Real const after = velocity(q.v, trial.v, contact.acceleration(trial), dt / 2);
    return {position(q.x, q.v, after, dt / 2), after};
  }
};
static_assert(PredictCorrectScheme<ModifiedVelocityVerlet>);

}  // namespace bagnold
