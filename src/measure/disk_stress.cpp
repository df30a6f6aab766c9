// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include <cstdint>

#include "kernels/device/dynamics/two_stage_leapfrog.hpp"
#include "src/config/time_step.hpp"
#include "src/measure/disk_search.hpp"
#include "src/engine/with_physics.hpp"

namespace bagnold {

namespace {

template <class Forces>
std::vector<Sums<false>> sums_of(Forces const& forces, std::size_t count) {
  std::vector<Sums<false>> of(count);
  for (std::uint32_t i = 0; i < count; ++i) add_pairs(forces, i, of[i]);
  return of;
}

template <Scheme scheme, ContactLaw Law, class Repulsion>
std::vector<Sums<false>> stress_under(Law const& law, Repulsion const& repulsion,
                                      Scene const& scene, State const& state) {
  auto const search = disk_search(state, 0.0);
  auto const count = state.count();
  ContactForces<Law, Repulsion, FrameSpace> const forces{
      search.position,
      to_device<FrameSpace>("measure::motion", motions<Law::rotates>(state)),
      search.species,
      make_neighbor_rows(FrameSpace{}, search, NeighborRows<FrameSpace>{}),
      make_species_table(scene.mass_by_area()),
      search.box,
      law,
      repulsion};
  if constexpr (scheme != Scheme::two_stage_leapfrog) {
    return sums_of(forces, count);
  } else {
    double const dt = time_step(scene);
    FirstStage<Law, Repulsion, FrameSpace> const first{
        forces, dt, Kokkos::View<Motion<Law::rotates>*, FrameSpace>("measure::change", count),
        Kokkos::View<int*, FrameSpace>("measure::contacts", count)};
    Real too_deep = 0;  // what engines stop for
    for (std::uint32_t i = 0; i < count; ++i) first(i, too_deep);
    auto const shares =
        to_device<FrameSpace>("measure::second_stage", std::vector{SecondStage(law, forces.table, dt)});
    return sums_of(
        ChangeForces<Law, Repulsion, FrameSpace>{forces, first.change, first.contacts, shares, dt},
        count);
  }
}

}  // namespace

std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state) {
  std::vector<Sums<false>> result;
  with_physics(scene, [&](auto const& law, auto const& repulsion, auto scheme) {
    result = stress_under<scheme()>(law, repulsion, scene, state);
  });
  return result;
}

}  // namespace bagnold
