// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>

#include "kernels/physics/multiply_add.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/lone_contact.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Motion of one disk for a one-body force, relative to the mean flow u(r) = gammadot y x^. T: a
/// number or pack.
template <class T>
struct DrivenDisk {
  Vec2<T> position;     ///< [d_s]
  Vec2<T> velocity;     ///< v - u(r), [d_s / tau_e]
  T spin;               ///< thetadot + gammadot/2: beyond the rotation of the flow, [1 / tau_e]
  T big;                ///< 1 of a big disk, 0 of a small one
  Vec2<T> random = {};  ///< uniform in (-1/2, 1/2), of the disk and the step; 0 if unused
  T random_spin = T(0);

  /// A number that depends on the size.
  KOKKOS_FORCEINLINE_FUNCTION T of(PerSpecies const& value) const {
    return multiply_add(big, T(value.big - value.small), T(value.small));
  }
};

/// Force and torque on one disk.
template <class T>
struct Push {
  Vec2<T> force{};  ///< [m d_s / tau_e^2]
  T torque = T(0);  ///< [m d_s^2 / tau_e^2]

  KOKKOS_FORCEINLINE_FUNCTION Push& operator+=(Push const& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

/// Response of a scheme to a force on one disk, and to its damping; z = zeta dt/m.
struct SchemeOnDisk {
  Real (*gain)(Real z);   ///< v -> v + gain(z) (f dt/m - z v) in a step, f a constant force
  Real (*share)(Real z);  ///< of the drag of the changes in the second stage; null: there is none
  Real trial = 1;         ///< of f dt/m, in the trial velocity
  Real velocity = 1;      ///< of f dt/m at the trial state, in the new velocity
  Real position = 1;      ///< of that times dt, in the new position

  template <class Scheme>
  static SchemeOnDisk of() {
    SchemeOnDisk on{
        [](Real z) {
          RelativeMotion const after = Scheme::step(RelativeMotion{0, 1}, LoneContact{0, z}, 1);
          return z == 0 ? 1 : (1 - after.v) / z;
        },
        nullptr};
    if constexpr (TwoStageScheme<Scheme>) {
      on.share = Scheme::share;
    } else if constexpr (PredictCorrectScheme<Scheme>) {
      Real const zero = 0, one = 1, half = 0.5;
      on.trial = Scheme::trial_velocity(zero, one, one);
      on.velocity = Scheme::velocity(zero, zero, one, half);
      on.position = Scheme::position(zero, zero, one, half);
    }
    return on;
  }
};

/// Parameters of a drive.
struct DriveInput {
  Real drag;         ///< zeta, [m / tau_e]
  Real temperature;  ///< T, [m d_s^2 / tau_e^2]
  SpeciesTable table;
  Real time_step;  ///< dt, [tau_e]
  SchemeOnDisk scheme;
};

/// zeta_r of a disk in a fluid that drags it with zeta, torque over spin: a sphere's ratio d^2/3,
/// pi eta d^3 over 3 pi eta d. [m d_s^2 / tau_e]
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T spin_drag(T const& drag, T const& diameter) {
  return drag * diameter * diameter * T(Real(1) / 3);
}

/// Stokes drag in the mean flow, P2 Sec. IV:
///
///     f = -zeta [v - u(r)],   torque = -zeta_r (thetadot + gammadot/2)
template <class T>
KOKKOS_FORCEINLINE_FUNCTION Push<T> drag_force(Real drag, DrivenDisk<T> const& disk) {
  T const diameter = disk.of({small_diameter, big_diameter});
  return {T(-drag) * disk.velocity, -spin_drag(T(drag), diameter) * disk.spin};
}

/// A one-body force: a drag, which engines step as the scheme steps damping, and a push besides. A
/// disk that touches nothing does not fly straight under it.
template <class D>
concept OneBodyDrive = requires(D const& drive, DriveInput const& input,
                                DrivenDisk<Real> const& disk) {
  { D::name } -> std::convertible_to<std::string_view>;  // as in input and output
  { D::random } -> std::convertible_to<bool>;            // uses random numbers
  { D::thermal } -> std::convertible_to<bool>;           // has a temperature
  { D::make(input) } -> std::same_as<D>;
  { drive.drag } -> std::convertible_to<Real>;  // zeta, [m / tau_e]
  { drive.push(disk) } -> std::same_as<Push<Real>>;
};

}  // namespace bagnold
