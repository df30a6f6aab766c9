// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include <cstdint>

#include "src/measure/disk_search.hpp"
#include "src/simulation/laws.hpp"

namespace bagnold {

namespace {

template <ContactLaw Law, class Repulsion>
std::vector<Sums<false>> stress_under(Law const& law, Repulsion const& repulsion,
                                      Scene const& scene, State const& state) {
  auto const search = disk_search(state, 0.0);
  ContactForces<Law, Repulsion, FrameSpace> const forces{
      search.position,
      to_device<FrameSpace>("measure::motion", motions<Law::rotates>(state)),
      search.species,
      make_neighbor_rows(FrameSpace{}, search, NeighborRows<FrameSpace>{}),
      make_species_table(scene.mass_by_area()),
      search.box,
      law,
      repulsion};
  std::vector<Sums<false>> of(state.count());
  for (std::uint32_t i = 0; i < of.size(); ++i) forces(i, PairSums<false>{of[i]});
  return of;
}

}  // namespace

std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state) {
  std::vector<Sums<false>> result;
  auto const use = [&]<class Law>(std::type_identity<Law>) {
    if (scene.disks.model != Law::name) return;
    auto const law = make_law<Law>(scene.disks);
    result = scene.disks.force_exponent == HertzianRepulsion::force_exponent
                 ? stress_under(law, HertzianRepulsion{}, scene, state)
                 : stress_under(law, HarmonicRepulsion{}, scene, state);
  };
  [&]<class... Law>(std::tuple<Law...> const*) {
    (use(std::type_identity<Law>{}), ...);
  }(static_cast<Laws const*>(nullptr));
  return result;
}

}  // namespace bagnold
