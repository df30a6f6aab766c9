// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/contact_rates.hpp"

#include "kernels/physics/species.hpp"
#include "src/config/laws.hpp"
#include "src/config/scene_physics.hpp"

namespace bagnold {

ContactRates::ContactRates(Scene const& scene) {
  double const small = make_species_table(scene.mass_by_area()).inverse_mass.small;
  with_repulsion(scene.disks, [&]<class Repulsion>(Repulsion) {
    stiffness = 2 * small * Repulsion::stiffness(largest_relative_overlap);
    harmonic = Repulsion::force_exponent == 2;
  });
  auto const& law = law_of(scene.disks);
  auto const constants = law.constants(scene.disks);
  normal = 2 * small * constants.normal;
  tangential = 2 * small * tangential_mobility(law.rotates) * constants.tangential;
  dense_flow = small * constants.dense_flow;
}

}  // namespace bagnold
