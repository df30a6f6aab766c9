// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/drives/drive_setup.hpp"

#include <bit>

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/scene.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

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

}  // namespace bagnold
