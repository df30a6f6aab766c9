// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/contact_rates.hpp"

#include "kernels/physics/species.hpp"
#include "src/config/scene_physics.hpp"

namespace bagnold {

ContactRates::ContactRates(Scene const& scene) {
  double const small = make_species_table(scene.mass_by_area()).inverse_mass.small;
  with_repulsion(scene.disks, [&]<class Repulsion>(Repulsion) {
    stiffness = 2 * small * Repulsion::stiffness(largest_relative_overlap);
    harmonic = Repulsion::force_exponent == 2;
  });
  with_law(scene.disks, [&]<ContactLaw Law>(Law const& law) {
    if constexpr (Law::linear) {
      normal = 2 * small * law.normal_damping();
      tangential = 2 * small * tangential_mobility(Law::rotates) * law.tangential_damping();
      dense_flow = small * law.dense_flow_rate();
    }
  });
}

}  // namespace bagnold
