// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Two disks i and j in contact, as the argument of a law.
template <class T>
struct Contact {
  Vec2<T> normal;      ///< r_ij / |r_ij|: from j to i
  Vec2<T> velocity;    ///< v_i - v_j with the shear of the image, [d_s / tau_e]; at the point of
                       ///< contact (P2 Eq. 6) if the law rotates, else of the centres
  T relative_overlap;  ///< 1 - r_ij / d_ij, in (0, 1)
  T inverse_distance;  ///< 1 / d_ij, [1 / d_s]
};

/// Largest relative overlap at which a soft disk is still taken for a grain.
inline constexpr Real largest_relative_overlap = 0.2;

/// Damping constants of a scene.
struct DampingInput {
  Real elasticity;      ///< Q; k_d = 1/Q (P1 Eq. 6, P2 Eq. 9)
  Real normal = 1;      ///< k_d^(n) Q, for laws with separate constants
  Real tangential = 1;  ///< k_d^(t) Q, for laws with separate constants
};

/// Facts that a law states about itself, one concept for each; ContactLaw requires all.
namespace law {

template <class Law>
concept Named = requires {
  { Law::name } -> std::convertible_to<std::string_view>;
};

/// States if disks have spins: the force then depends on the velocity at the point of contact.
template <class Law>
concept SaysWhetherItRotates = requires {
  { Law::rotates } -> std::convertible_to<bool>;
};

/// Has the force on i from j.
template <class Law>
concept Forceful = requires(Law const law, Contact<Real> const contact) {
  { law.dissipative_force(contact) } -> std::same_as<Vec2<Real>>;
};

/// States if the force is linear in the velocity.
template <class Law>
concept SaysWhetherItIsLinear = requires {
  { Law::linear } -> std::convertible_to<bool>;
};

/// Makes the law of a scene, with constants proportional to 1/Q, and states if it has separate
/// constants along the normal and the tangent (disks.damping_normal and disks.damping_tangential).
template <class Law>
concept MadeFromInput = requires(DampingInput const& input) {
  { Law::make(input) } -> std::same_as<Law>;
  { Law::separate_constants } -> std::convertible_to<bool>;
};

/// States the papers' time step at an elasticity Q, [tau_e].
template <class Law>
concept FollowsAPaper = requires(Real elasticity) {
  { Law::paper_time_step(elasticity) } -> std::convertible_to<Real>;
};

/// States the constants of a linear law: f_dis = -k_n v_n n - k_t v_t.
template <class Law>
concept HasConstants = requires(Law const law) {
  { law.normal_damping() } -> std::same_as<Real>;      // k_n, [m / tau_e]
  { law.tangential_damping() } -> std::same_as<Real>;  // k_t, [m / tau_e]
  { Law::one_constant } -> std::convertible_to<bool>;  // k_t is k_n, or 0, whatever the parameters
};

}  // namespace law

/// A force of disks in contact, as pair loops need it.
template <class Law>
concept PairLaw = law::SaysWhetherItRotates<Law> && law::Forceful<Law>;

/// A contact law: all that the program requires of one. A law that is not linear has no constants.
template <class Law>
concept ContactLaw = law::Named<Law> && PairLaw<Law> && law::MadeFromInput<Law> &&
    law::FollowsAPaper<Law> && law::SaysWhetherItIsLinear<Law> &&
    (!Law::linear || law::HasConstants<Law>);

/// A law whose damping is linear in the velocity.
template <class Law>
concept LinearLaw = ContactLaw<Law> && Law::linear;

/// A law for two-stage damping, whose second stage acts on weighted changes of the velocity
/// (kernels/physics/schemes/second_stage.hpp). It is linear in them and, without spins, has one
/// weight for both directions.
template <class Law>
concept TwoStageLaw = LinearLaw<Law> &&(Law::rotates || Law::one_constant);

/// True, or one error of the compiler for each fact that a law lacks.
template <class Law>
constexpr bool is_contact_law() {
  static_assert(law::Named<Law>, "a contact law has `static constexpr std::string_view name`");
  static_assert(law::SaysWhetherItRotates<Law>,
                "a contact law has `static constexpr bool rotates`: whether it needs spins");
  static_assert(law::Forceful<Law>,
                "a contact law has `template <class T> KOKKOS_FUNCTION Vec2<T> "
                "dissipative_force(Contact<T> const&) const`");
  static_assert(law::SaysWhetherItIsLinear<Law>,
                "a contact law has `static constexpr bool linear`: whether its force is linear in "
                "the velocity");
  static_assert(law::MadeFromInput<Law>,
                "a contact law has `static Law make(DampingInput const&)` and `static constexpr "
                "bool separate_constants`");
  static_assert(law::FollowsAPaper<Law>,
                "a contact law has `static Real paper_time_step(Real elasticity)`, see "
                "laws/paper_time_step.hpp");
  if constexpr (law::SaysWhetherItIsLinear<Law>)
    static_assert(
        !Law::linear || law::HasConstants<Law>,
        "a law linear in the velocity has normal_damping() and tangential_damping(), both Real "
        "and const, and `static constexpr bool one_constant`");
  return true;
}

}  // namespace bagnold
