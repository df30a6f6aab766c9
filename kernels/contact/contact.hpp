// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>

#include "kernels/core/vec2.hpp"

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

/// A dissipative contact law: name, whether it needs spins, and the force on i from j.
template <class Law>
concept ContactLaw = requires(Law const law, Contact<Real> const contact) {
  { Law::name } -> std::convertible_to<std::string_view>;
  { Law::rotates } -> std::convertible_to<bool>;
  { law.dissipative_force(contact) } -> std::same_as<Vec2<Real>>;
};

}  // namespace bagnold
