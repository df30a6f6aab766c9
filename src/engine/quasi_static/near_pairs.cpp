// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/near_pairs.hpp"

#include <algorithm>

#include "kernels/device/neighbors/verlet_list.hpp"
#include "src/engine/compiled_once.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold::quasi_static {

std::vector<NearPair> near_pairs(std::vector<Vec2<Real>> const& position,
                                 std::vector<Species> const& species, SpeciesTable const& table,
                                 ShearedBox const& box, Real skin) {
  using Space = Kokkos::Serial;
  VerletList<Space> list{skin, to_device<Space>("quasi_static::at_build", position), {}};
  build_list(Space{}, list, to_device<Space>("quasi_static::species", species), table, box);
  std::vector<NearPair> pairs;
  for (std::uint32_t i = 0; i < position.size(); ++i)
    for (auto k = list.rows.begin(i); k < list.rows.end(i); ++k) {
      Neighbor const neighbor = list.rows.entry(k);
      auto const j = neighbor.index();
      if (j < i) continue;
      Real const distance = (table.diameter[species[i]] + table.diameter[species[j]]) / 2;
      pairs.push_back({i, j, neighbor.image(), distance});
    }
  return pairs;
}

}  // namespace bagnold::quasi_static
