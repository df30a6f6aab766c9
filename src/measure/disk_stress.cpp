// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include <cstdint>

#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/sums/measure.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/with_physics.hpp"
#include "src/measure/disk_search.hpp"

namespace bagnold {

namespace {

template <class Forces>
std::vector<Sums<false>> sums_of(Forces const& forces, std::size_t count) {
  std::vector<Sums<false>> of(count);
  for (std::uint32_t i = 0; i < count; ++i) add_pairs(forces, i, of[i]);
  return of;
}

template <ContactLaw Law, class Repulsion, class Scheme>
std::vector<Sums<false>> stress_under(Law const& law, Repulsion const&, Scheme, Scene const& scene,
                                      State const& state) {
  auto const search = disk_search(state, 0.0);
  SteppedSystem<Law, Repulsion, FrameSpace, Scheme> system{
      {}, make_species_table(scene.mass_by_area()), law, time_step(scene)};
  auto& disks = system.disks;
  disks.position = search.position;
  disks.species = search.species;
  disks.motion = to_device<FrameSpace>("measure::motion", motions<Law::rotates>(state));
  disks.trial_motion = decltype(disks.trial_motion)("measure::trial_motion", state.count());
  disks.neighbors = make_neighbor_rows(FrameSpace{}, search, NeighborRows<FrameSpace>{});
  disks.step.allocate(law, system.table, system.time_step, state.count());
  system.begin_step(Launches<FrameSpace>{}, search.box);  // engines stop for deep overlaps
  return sums_of(system.measured_forces(search.box), state.count());
}

}  // namespace

std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state) {
  std::vector<Sums<false>> result;
  with_physics(scene, [&](auto const& law, auto const& repulsion, auto scheme) {
    result = stress_under(law, repulsion, scheme, scene, state);
  });
  return result;
}

}  // namespace bagnold
