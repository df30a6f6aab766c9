// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/neighbors/neighbor_rows.hpp"
#include "kernels/device/sums/measure.hpp"
#include "src/engine/device_copy.hpp"
#include "src/engine/law_engines.hpp"
#include "src/engine/with_physics.hpp"

namespace bagnold::detail {

/// LawEngines::disk_sums of one law.
template <ContactLaw Law>
std::vector<Sums<false>> disk_sums(EngineInput const& input, State const& state,
                                   HostSearch const& search) {
  using Space = Kokkos::Serial;
  return with_physics_of<Law>(input.physics, [&]<class Repulsion, class Scheme>(
                                                 Law const& law, Repulsion const&, Scheme) {
    SteppedSystem<Law, Repulsion, Space, Scheme> system{{}, input.species, law, input.time_step};
    auto& disks = system.disks;
    disks.position = search.position;
    disks.species = search.species;
    disks.motion = to_device<Space>("measure::motion", motions<Law::rotates>(state));
    if constexpr (PredictCorrectScheme<Scheme>)
      disks.trial_position =
          decltype(disks.trial_position)("measure::trial_position", state.count());
    disks.trial_motion = decltype(disks.trial_motion)("measure::trial_motion", state.count());
    NeighborRows<Space> const none;
    disks.neighbors = make_neighbor_rows(Space{}, search, none);
    disks.step.allocate(law, system.table, system.time_step, state.count());
    system.begin_step(Launches<Space>{}, search.box);  // engines stop for deep overlaps
    auto const forces = system.measured_forces(search.box);
    std::vector<Sums<false>> of(state.count());
    for (std::uint32_t i = 0; i < of.size(); ++i) add_pairs(forces, i, of[i]);
    return of;
  });
}

}  // namespace bagnold::detail
