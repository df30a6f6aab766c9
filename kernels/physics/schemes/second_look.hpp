// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/schemes/second_stage.hpp"

/// Old names.
namespace bagnold {

using SecondLook = SecondStage;

template <TwoStageLaw Law, class T>
KOKKOS_FUNCTION Vec2<T> looked_at(Vec2<T> const& change, Vec2<T> const& normal, T const& share_normal,
                                  T const& share_tangential) {
  return second_stage_velocity<Law>(change, normal, share_normal, share_tangential);
}

template <ContactLaw Law, class T>
KOKKOS_FUNCTION Vec2<T> own_change(PairForce<T> const& damping, T const& inverse_distance,
                                   T const& per_force, T const& per_turn) {
  return change_of_pair<Law>(damping.dissipative, damping.turn(inverse_distance),
                             damping.separation, inverse_distance, per_force, per_turn);
}

}  // namespace bagnold
