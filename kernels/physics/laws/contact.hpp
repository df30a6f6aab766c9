// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Two disks i and j in contact, as a law sees them.
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

/// What a law whose force is linear in the velocity says of it: f_dis = -k_n v_n n - k_t v_t.
template <class Law>
concept DampingConstants = requires(Law const law) {
  { law.normal_damping() } -> std::same_as<Real>;      // k_n, [m / tau_e]
  { law.tangential_damping() } -> std::same_as<Real>;  // k_t, [m / tau_e]
  { Law::one_constant } -> std::convertible_to<bool>;  // k_t is k_n, or 0, whatever the parameters
};

/// A dissipative contact law: name, whether it needs spins, the force on i from j, whether that is
/// linear in the velocity, and its constants if it is.
template <class Law>
concept ContactLaw = requires(Law const law, Contact<Real> const contact) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::rotates } -> std::convertible_to<bool>;
  { Law::linear } -> std::convertible_to<bool>;
  { law.dissipative_force(contact) } -> std::same_as<Vec2<Real>>;
} && (!Law::linear || DampingConstants<Law>);

/// A law for two-stage damping, whose second stage acts on weighed changes of the velocity
/// (kernels/physics/schemes/second_stage.hpp): linear in them and, without spins, with one weight for both
/// directions.
template <class Law>
concept TwoStageLaw = ContactLaw<Law> && Law::linear && (Law::rotates || Law::one_constant);

}  // namespace bagnold
