// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/contact/contact.hpp"
#include "kernels/core/species.hpp"

namespace bagnold {

/// What share of the damping of the changes acts in the second look of TwoStageLeapfrog:
///
///     alpha(z) = max{1/7, (z - 1 + e^-z) / z^2},   z = N k_d dt (1/m_i + 1/m_j),
///
/// with three times that z along the tangent of disks that rotate (d_i^2/4I_i + d_j^2/4I_j = 2/mu).
/// N: the contacts of the one of the two disks that has more. For N = 1 the pair slows down by e^-z
/// exactly; 1 - z + alpha z^2 stays within (-1, 1] up to z = 7 for any N.
struct SecondLook {
  static constexpr int most = 8;  ///< N beyond it counts as it
  static constexpr int classes = 3;  ///< small-small, small-big, big-big
  Real normal[classes][most];
  Real tangential[classes][most];

  SecondLook() = default;

  /// The law is linear in the velocity, with these constants along the normal and the tangent.
  template <ContactLaw Law>
  SecondLook(Law const& law, SpeciesTable const& table, Real time_step) {
    for (int c = 0; c < classes; ++c)
      for (int n = 1; n <= most; ++n) {
        Real const z = n * time_step *
                       (table.inverse_mass[c == 2] + table.inverse_mass[c == 0 ? 0 : 1]);
        normal[c][n - 1] = share(law.normal_damping() * z);
        tangential[c][n - 1] = share(law.tangential_damping() * z * (Law::rotates ? 3 : 1));
      }
  }

  static Real share(Real z) {
    Real const exact = z < Real(1e-3) ? Real(0.5) - z / 6 + z * z / 24
                                      : (z + std::expm1(-z)) / (z * z);
    return exact > Real(1) / 7 ? exact : Real(1) / 7;
  }
};

/// The velocity at a contact whose damping the second look adds. change: of v_i - v_j, at the point of
/// contact if the law rotates.
template <ContactLaw Law, class T>
KOKKOS_FUNCTION Vec2<T> looked_at(Vec2<T> const& change, Vec2<T> const& normal, T const& share_normal,
                                  T const& share_tangential) {
  if constexpr (Law::rotates)
    return share_tangential * change +
           ((share_normal - share_tangential) * dot(change, normal)) * normal;
  else
    return share_normal * change;  // CD: one and the same share; CD_n: no force along the tangent
}

}  // namespace bagnold
