// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cstdint>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Size of a disk, one of two: one byte a disk instead of its diameter, mass and inertia.
using Species = std::uint8_t;

/// A number for each size. It is not an array, which a GPU would keep in memory to look it up by an
/// index.
struct PerSpecies {
  Real small, big;

  KOKKOS_FUNCTION constexpr Real operator[](Species species) const {
    return species == 0 ? small : big;
  }
};

/// Properties of each size. The mass rule enters here and nowhere else.
struct SpeciesTable {
  PerSpecies diameter;         ///< d, [d_s]
  PerSpecies inverse_mass;     ///< 1/m, [1/m] (P2) or [1/m_0] (P1)
  PerSpecies inverse_inertia;  ///< 1/I
};

inline constexpr Real small_diameter = 1.0;
inline constexpr Real big_diameter = 1.4;

/// Pairs by their contact distance: small-small, small-big (in this order in lists), big-big.
inline constexpr int pair_classes = 3;

KOKKOS_INLINE_FUNCTION constexpr int pair_class(Species a, Species b) { return a + b; }

/// Diameters of the disks of a pair of a class, the smaller one first as in lists, [d_s].
KOKKOS_INLINE_FUNCTION constexpr Real first_diameter(int pair_class) {
  return pair_class == 2 ? big_diameter : small_diameter;
}
KOKKOS_INLINE_FUNCTION constexpr Real second_diameter(int pair_class) {
  return pair_class == 0 ? small_diameter : big_diameter;
}

/// Contact distance of a class, d_ij = (d_i + d_j)/2, [d_s]; selected from constants.
KOKKOS_INLINE_FUNCTION constexpr Real class_distance(int pair_class) {
  return pair_class == 0   ? small_diameter
         : pair_class == 1 ? (small_diameter + big_diameter) / 2
                           : big_diameter;
}

/// 1/d_ij, [1/d_s].
KOKKOS_INLINE_FUNCTION constexpr Real inverse_class_distance(int pair_class) {
  return pair_class == 0   ? 1 / small_diameter
         : pair_class == 1 ? 1 / ((small_diameter + big_diameter) / 2)
                           : 1 / big_diameter;
}

/// Mass m of a disk of diameter d: 1 (P2, `equal`), or (pi/2) d^2 (P1, `area`: m_0 = rho_0
/// d_s^2/2).
constexpr Real disk_mass(bool by_area, Real diameter) {
  return by_area ? Real(1.57079632679489661923) * diameter * diameter : Real(1);
}

/// Moment of inertia of a disk, m (d/2)^2 / 2, P2 below Eq. (7).
constexpr Real disk_inertia(bool by_area, Real diameter) {
  return disk_mass(by_area, diameter) * diameter * diameter / 8;
}

/// Ratio of the changes of the velocity at the point of contact of two disks by equal forces along
/// the tangent and along the normal: mu/mu_t = 1, or where they roll 1 + mu (d_i^2/4I_i +
/// d_j^2/4I_j) = 3.
constexpr Real tangential_mobility(bool rotates) { return rotates ? 3 : 1; }

constexpr SpeciesTable make_species_table(bool mass_by_area) {
  Real const small = disk_mass(mass_by_area, small_diameter);
  Real const big = disk_mass(mass_by_area, big_diameter);
  return {{small_diameter, big_diameter},
          {1 / small, 1 / big},
          {1 / disk_inertia(mass_by_area, small_diameter),
           1 / disk_inertia(mass_by_area, big_diameter)}};
}

}  // namespace bagnold
