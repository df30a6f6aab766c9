// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/engine_input.hpp"

#include <bit>

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/laws.hpp"
#include "src/config/scene_physics.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

std::optional<DriveSetup> drive_setup(Scene const& scene, double initial_time) {
  if (!scene.driven()) return std::nullopt;
  auto const scheme = with_named<Schemes>(
      scheme_of(scene), []<class S>(std::type_identity<S>) { return SchemeOnDisk::of<S>(); });
  auto const seed = static_cast<std::uint64_t>(scene.disks.seed);
  return DriveSetup{scene.drive.kind,
                    {scene.drive.drag, scene.drive.temperature,
                     make_species_table(scene.mass_by_area()), time_step(scene), scheme},
                    RandomStream(Stream::thermal_noise,
                                 seed ^ mixed(std::bit_cast<std::uint64_t>(initial_time)))};
}

}  // namespace

PhysicsInput physics_input(Scene const& scene) {
  return {damping_input(scene.disks), scene.disks.force_exponent, std::string(scheme_of(scene)),
          scene.integration.scheme};
}

EngineInput engine_input(Scene const& scene, double initial_time) {
  auto const& law = law_of(scene.disks);
  auto const damping = law.constants(scene.disks);
  return {scene.disks.model,
          scene.integration.engine,
          physics_input(scene),
          law.rotates,
          damping.normal,
          damping.tangential,
          make_species_table(scene.mass_by_area()),
          strain_rates(scene),
          time_step(scene),
          skin(scene),
          scene.measure.contacts,
          drive_setup(scene, initial_time)};
}

}  // namespace bagnold
