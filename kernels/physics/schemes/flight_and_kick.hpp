// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/multiply_add.hpp"

/// Building blocks of all schemes. T: a number or pack; V: Vec2<T>, or T for the spin.
namespace bagnold {

/// r + v dt: a disk that touches nothing.
template <class T, class V>
KOKKOS_FORCEINLINE_FUNCTION V flown(V const& position, V const& velocity, T const& time) {
  return multiply_add(time, velocity, position);
}

/// v + f dt/m. per_mass: dt/m, or for the spin dt/I with the torque, dt d/I with torque over
/// diameter.
template <class T, class V>
KOKKOS_FORCEINLINE_FUNCTION V kicked(V const& velocity, V const& force, T const& per_mass) {
  return multiply_add(per_mass, force, velocity);
}

}  // namespace bagnold
