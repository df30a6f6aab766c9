// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include "kernels/physics/schemes/modified_velocity_verlet.hpp"
#include "src/config/events.hpp"
#include "src/engine/law_engines.hpp"
#include "src/measure/disk_search.hpp"

namespace bagnold {

std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state) {
  auto const search = disk_search(state, 0.0);
  auto const& engines = engines_for(scene.disks.model);
  if (!has_events(scene)) return engines.disk_sums(engine_input(scene), state, search);
  Scene instant = scene;  // no step: the forces of the state alone
  instant.integration.scheme = ModifiedVelocityVerlet::name;
  instant.integration.engine = "auto";
  return engines.disk_sums(engine_input(instant), state, search);
}

}  // namespace bagnold
