// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/core/vec2.hpp"

namespace bagnold {

/// Which of the two sizes a disk has: one byte a disk instead of its diameter, mass and inertia.
using Species = std::uint8_t;

/// What a size implies. The mass rule is folded in here and appears nowhere else.
struct SpeciesTable {
  Real diameter[2];         ///< d, [d_s]
  Real inverse_mass[2];     ///< 1/m, [1/m] (P2) or [1/m_0] (P1)
  Real inverse_inertia[2];  ///< 1/I with I = m (d/2)^2 / 2, P2 below Eq. (7)
};

inline constexpr Real small_diameter = 1.0;
inline constexpr Real big_diameter = 1.4;

/// Mass m of a disk of diameter d: 1 (P2, `equal`), or (pi/2) d^2 (P1, `area`: m_0 = rho_0 d_s^2/2).
constexpr Real disk_mass(bool by_area, Real diameter) {
  return by_area ? Real(1.57079632679489661923) * diameter * diameter : Real(1);
}

constexpr SpeciesTable make_species_table(bool mass_by_area) {
  SpeciesTable table{};
  Real const diameters[2] = {small_diameter, big_diameter};
  for (int s = 0; s < 2; ++s) {
    Real const d = diameters[s];
    Real const mass = disk_mass(mass_by_area, d);
    table.diameter[s] = d;
    table.inverse_mass[s] = 1 / mass;
    table.inverse_inertia[s] = 8 / (mass * d * d);
  }
  return table;
}

}  // namespace bagnold
