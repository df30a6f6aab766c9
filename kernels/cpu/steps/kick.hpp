// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Factors by which forces on a pack of disks, acting for a time, change their motion, by species.
struct Kick {
  simd::Pack mass[2], inertia[2];

  /// time: [tau_e].
  Kick(SpeciesTable const& table, Real time) {
    for (int s = 0; s < 2; ++s) {
      mass[s] = time * table.inverse_mass[s];
      inertia[s] = time * table.diameter[s] * table.inverse_inertia[s];
    }
  }
  simd::Pack per_mass(simd::Mask big) const { return select(big, mass[1], mass[0]); }  ///< dt / m
  simd::Pack per_inertia(simd::Mask big) const {                                       ///< dt d / I
    return select(big, inertia[1], inertia[0]);
  }
};

/// Diameters of a pack of disks, [d_s].
inline simd::Pack diameter_of(simd::Mask big) {
  return select(big, simd::Pack(big_diameter), simd::Pack(small_diameter));
}

}  // namespace bagnold
