// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/lone_contact.hpp"

namespace bagnold {

/// Velocity Verlet whose trial velocity is that of half a kick:
///
///     v~ = v_0 + f(r_0, v_0) dt/2m,     r~ = r_0 + v_0 dt
///     v_1 = v~ + f(r~, v~) dt/2m,       r_1 = r_0 + (v_0 + v_1) dt/2
struct HalfKickVerlet {
  static constexpr std::string_view name = "half-kick-verlet";  ///< as in input and output

  /// Largest rate of damping that does not grow, times dt: (1 - y/2)^2 <= 1.
  static constexpr Real largest_rate = 4;
  /// Largest frequency without damping, times dt: of a velocity Verlet.
  static constexpr Real largest_frequency = 2;

  template <ContactLaw Law>
  static constexpr bool can_step = true;

  template <ContactLaw Law>
  static Real time_step(DampingInput const& input) {
    return Law::paper_time_step(input.elasticity);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V trial_velocity(V const& velocity, V const& force,
                                                      T const& per_mass) {
    return kicked(velocity, force, T(0.5) * per_mass);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V trial_position(V const& position, V const& velocity,
                                                      T const& time_step) {
    return flown(position, velocity, time_step);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V velocity(V const&, V const& trial, V const& force,
                                                T const& half_per_mass) {
    return kicked(trial, force, half_per_mass);
  }

  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION static V position(V const& position, V const& before, V const& after,
                                                T const& half_time_step) {
    return flown(position, before + after, half_time_step);
  }

  /// Of two disks that touch no other.
  static RelativeMotion step(RelativeMotion const& q, LoneContact const& contact, Real dt) {
    RelativeMotion const trial{trial_position(q.x, q.v, dt),
                               trial_velocity(q.v, contact.acceleration(q), dt)};
    Real const after = velocity(q.v, trial.v, contact.acceleration(trial), dt / 2);
    return {position(q.x, q.v, after, dt / 2), after};
  }
};

}  // namespace bagnold
