// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/events/linear_damping.hpp"
#include "kernels/physics/closed_form/contact_class.hpp"

namespace bagnold::events {

/// Limits of a step of a cluster: the phase of a lone contact's oscillation, and the exponent by
/// which its damping acts. Most steps are shorter, by their error.
inline constexpr Real longest_phase = 1.5, longest_decay = 2;

/// Contact law and masses of the disks, at one speed of time.
template <bool Rotates>
struct Material {
  SpeciesTable table;
  LinearDamping<Rotates> damping;
  ContactClasses<Rotates> classes;
  Real longest_step = 0;  ///< of a cluster, [tau_e]
  Real remember = 0;      ///< longer than any lone contact and any step, [tau_e]

  static Material of(LinearDamping<Rotates> const& damping, SpeciesTable const& table) {
    Material material{table, damping, {}};
    Real fastest = 0;
    for (Species i = 0; i < 2; ++i)
      for (Species j = 0; j < 2; ++j)
        material.classes.of[i][j] =
            ContactClass<Rotates>::of_constants(damping.normal, damping.tangential, table, i, j);
    for (auto const& row : material.classes.of)
      for (auto const& c : row)
        fastest = std::max({fastest, c.frequency0 / longest_phase,
                            2 * c.rates.damping / longest_decay, c.rates.sliding / longest_decay});
    material.longest_step = 1 / fastest;
    material.remember = material.longest_step;
    for (auto const& row : material.classes.of)
      for (auto const& c : row) material.remember = std::max(material.remember, 2 * c.half_period);
    return material;
  }

  /// Material where times are `speed` times as long: masses grow with its square, the damping with
  /// it, and forces, energies and kinetic stresses stay what they are.
  static Material of(LinearDamping<Rotates> const& damping, SpeciesTable table, Real speed) {
    for (auto* const of_disks : {&table.inverse_mass, &table.inverse_inertia})
      *of_disks = {of_disks->small / (speed * speed), of_disks->big / (speed * speed)};
    return of(LinearDamping<Rotates>{speed * damping.normal, speed * damping.tangential}, table);
  }
};

}  // namespace bagnold::events
