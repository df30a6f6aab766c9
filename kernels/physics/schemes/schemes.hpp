// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <tuple>

#include "kernels/physics/laws/archetype.hpp"
#include "kernels/physics/schemes/implicit_damping.hpp"
#include "kernels/physics/schemes/modified_velocity_verlet.hpp"
#include "kernels/physics/schemes/two_stage_leapfrog.hpp"

namespace bagnold {

/// Requirements on a scheme: its facts, and one of the forms that engines step.
template <class S>
concept SteppingScheme = (PredictCorrectScheme<S> || TwoStageScheme<S> ||
                          ImplicitScheme<S>)&&requires(RelativeMotion const& q,
                                                       LoneContact const& contact, Real dt) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::largest_rate } -> std::convertible_to<Real>;       // of damping that does not grow, times dt
  { S::largest_frequency } -> std::convertible_to<Real>;  // without damping, times dt
  { S::step(q, contact, dt) } -> std::same_as<RelativeMotion>;
  { S::template can_step<ArchetypeLaw> } -> std::convertible_to<bool>;
  { S::template time_step<ArchetypeLaw>(DampingInput{}) } -> std::convertible_to<Real>;  // [tau_e]
};

/// All schemes.
using Schemes = std::tuple<ModifiedVelocityVerlet,  //
                           TwoStageLeapfrog,        //
                           ImplicitDamping>;

template <class... S>
constexpr bool are_schemes(std::tuple<S...> const*) {
  return (SteppingScheme<S> && ...);
}
static_assert(are_schemes(static_cast<Schemes const*>(nullptr)));

/// Scheme of "auto".
using DefaultScheme = TwoStageLeapfrog;

}  // namespace bagnold
