// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/math.hpp"
#include "kernels/physics/species.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Skin with which a list, of pairs within d_ij + skin, still holds every pair in contact under
/// shear, [d_s].
///
/// Since the build the box has sheared by Delta gamma and a disk has moved to
///     r = r_0 + Delta gamma y_0 x^ + w
/// (unwrapped; r_0 the position at the build, w the non-affine displacement, zero at the
/// build). Images move with the mean flow, so for every pair image
///     r_ij = S r_0,ij + w_i - w_j,   S = [[1, Delta gamma], [0, 1]].
/// If |r_ij| < d_ij then |r_0,ij| <= |S^-1| (d_ij + 2 max|w|), and the norm of S^-1 is
///     s = |Delta gamma|/2 + sqrt(1 + Delta gamma^2/4).
/// The pair is in the list if that is below d_ij + skin, so the skin must be above
///     2 s max|w| + (s - 1) d_max.
KOKKOS_INLINE_FUNCTION Real list_margin(Real strain_since_build, Real largest_nonaffine) {
  Real const half = math::sqrt(strain_since_build * strain_since_build) / 2;
  Real const s = half + math::sqrt(1 + half * half);
  return 2 * s * largest_nonaffine + (s - 1) * big_diameter;
}

/// True if a list still holds every pair in contact.
KOKKOS_INLINE_FUNCTION bool list_holds(Real strain_since_build, Real largest_nonaffine2,
                                       Real skin) {
  return list_margin(strain_since_build, math::sqrt(largest_nonaffine2)) < skin;
}

/// Largest |w| at which a list still holds every pair in contact, [d_s]; negative if the shear
/// alone is too much.
KOKKOS_INLINE_FUNCTION Real list_reach(Real strain_since_build, Real skin) {
  Real const half = math::sqrt(strain_since_build * strain_since_build) / 2;
  Real const s = half + math::sqrt(1 + half * half);
  return (skin - (s - 1) * big_diameter) / (2 * s);
}

/// |w|^2 of a disk, [d_s^2]: its squared distance from where the mean flow alone would have taken
/// it.
KOKKOS_INLINE_FUNCTION Real nonaffine2(Vec2<Real> const& position, Vec2<Real> const& at_build,
                                       Real strain_since_build) {
  Vec2<Real> w = position - at_build;
  w.x -= strain_since_build * at_build.y;
  return dot(w, w);
}

}  // namespace bagnold
