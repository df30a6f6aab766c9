// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/sums/sums.hpp"
#include "src/engine/quasi_static/step_equations.hpp"

namespace bagnold::quasi_static {

/// Sums over the configuration at the end of a step: pairs with the forces of the step, disks with
/// their motion. Pairs that separated in the step have a dissipative force, but are not contacts.
template <bool Rotates>
Sums<Rotates> step_sums(Material const& material, std::vector<ActivePair> const& active,
                        std::vector<Vec2<Real>> const& position, Eigen::VectorXd const& motion,
                        Real strain_rate) {
  constexpr int unknowns = StepEquations<Rotates>::unknowns;
  Sums<Rotates> sums;
  for (auto const& pair : active) {
    add_pair(sums.value, pair.force, Real(1));
    if (!pair.touches) sums.value[SumColumns::contacts] -= 2;
    if constexpr (Rotates) {
      Real const turn = material.diameter(pair.i) * motion[unknowns * pair.i + 2] +
                        material.diameter(pair.j) * motion[unknowns * pair.j + 2];
      Real const inverse_distance = 2 / (material.diameter(pair.i) + material.diameter(pair.j));
      sums.value[SumColumns::torque_power] +=
          turn * pair.force.torque_per_diameter(inverse_distance);
    }
  }
  for (std::size_t i = 0; i < position.size(); ++i) {
    auto const at = unknowns * static_cast<Eigen::Index>(i);
    Real const mass = 1 / material.table.inverse_mass[material.species[i]];
    add_motion(sums.value, mass, peculiar_x(motion[at], position[i].y, strain_rate),
               motion[at + 1]);
    if constexpr (Rotates) add_spin(sums.value, motion[at + 2]);
  }
  return sums;
}

}  // namespace bagnold::quasi_static
