// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/engine_input.hpp"

#include "src/config/scene_physics.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

PhysicsInput physics_input(Scene const& scene) {
  return {damping_input(scene.disks), scene.disks.force_exponent, std::string(scheme_of(scene)),
          scene.integration.scheme};
}

EngineInput engine_input(Scene const& scene, double initial_time) {
  return {scene.disks.model,
          scene.integration.engine,
          physics_input(scene),
          make_species_table(scene.mass_by_area()),
          strain_rates(scene),
          time_step(scene),
          skin(scene),
          scene.measure.contacts,
          drive_setup(scene, initial_time)};
}

}  // namespace bagnold
