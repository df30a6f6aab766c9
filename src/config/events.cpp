// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/events.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/physics/species.hpp"
#include "src/config/abilities.hpp"
#include "src/config/laws.hpp"
#include "src/config/schemes.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

/// Largest k_n with which all contacts oscillate: 2 sqrt(mu)/d_ij of the pair that has the
/// smallest.
double most_damping(Scene const& scene) {
  auto const table = make_species_table(scene.mass_by_area());
  double least = 1e300;
  for (Species i = 0; i < 2; ++i)
    for (Species j = 0; j < 2; ++j) {
      double const mass = 1 / (table.inverse_mass[i] + table.inverse_mass[j]);
      least = std::min(least, 2 * std::sqrt(mass) / class_distance(pair_class(i, j)));
    }
  return least;
}

double normal_damping(Scene const& scene) {
  auto const* law = known_laws().find(scene.disks.model);
  return law ? law->constants(scene.disks).normal : 0;
}

}  // namespace

bool has_events(Scene const& scene) { return scene.integration.engine == event_engine; }

bool may_take_events(Scene const& scene) {
  if (scene.integration.engine != automatic) return false;
  if (!can_take_turns(scene)) return false;
  Scene by_rule = scene;
  by_rule.integration.time_step = automatic;
  return time_step(scene) == time_step(by_rule);
}

double least_underdamped_elasticity(Scene const& scene) {
  return scene.disks.elasticity * normal_damping(scene) / most_damping(scene);
}

}  // namespace bagnold
