// SPDX-License-Identifier: BSD-3-Clause
#include "bench/accuracy/near_pairs.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"

namespace bagnold::accuracy {

namespace {

using Space = Kokkos::Serial;
using Pairs = std::vector<NearPair>;

template <class T>
Kokkos::View<T*, Space> view_of(std::string const& label, std::vector<T> const& values) {
  Kokkos::View<T*, Space> view(label, values.size());
  std::copy(values.begin(), values.end(), view.data());
  return view;
}

bool meet(NearPair const& a, NearPair const& b) {
  return a.i == b.i || a.i == b.j || a.j == b.i || a.j == b.j;
}

/// Rearranged so that pairs of one pack of eight have no disk in common: each pair goes into the
/// first pack with room where it meets no other.
Pairs in_packs(Pairs const& pairs) {
  std::vector<Pairs> packs;
  std::size_t first_open = 0;
  for (NearPair const& pair : pairs) {
    auto const takes = [&](Pairs const& pack) {
      return pack.size() < simd::width &&
             std::none_of(pack.begin(), pack.end(), [&](auto const& p) { return meet(p, pair); });
    };
    auto const found =
        std::find_if(packs.begin() + static_cast<std::ptrdiff_t>(first_open), packs.end(), takes);
    if (found == packs.end())
      packs.push_back({pair});
    else
      found->push_back(pair);
    while (first_open < packs.size() && packs[first_open].size() == simd::width) ++first_open;
  }
  Pairs all;
  for (Pairs const& pack : packs) all.insert(all.end(), pack.begin(), pack.end());
  return all;
}

Pairs by_class_in_packs(Pairs const& pairs) {
  Pairs all;
  for (int big = 0; big < 3; ++big) {
    Pairs of_class;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(of_class),
                 [&](NearPair const& pair) { return pair.big == big; });
    Pairs const packs = in_packs(of_class);
    all.insert(all.end(), packs.begin(), packs.end());
  }
  return all;
}

}  // namespace

NearPairs find_near_pairs(std::vector<Vec2<Real>> const& position,
                          std::vector<Species> const& species, ShearedBox const& box, Real skin,
                          Arrangement const& arrangement) {
  auto const place = view_of("accuracy::position", position);
  auto const grid = make_cell_grid(Space(), place, box, big_diameter + skin);
  NeighborSearch<Space> const search{
      place, view_of("accuracy::species", species), grid, make_species_table(false), box, skin};
  auto const rows = make_neighbor_rows(Space(), search, NeighborRows<Space>{});

  auto const tile = [&](std::uint32_t i) {
    auto const cut = [&](Real share) {
      return std::clamp(static_cast<int>(share * arrangement.tiles), 0, arrangement.tiles - 1);
    };
    return cut(position[i].y / box.height) * arrangement.tiles + cut(position[i].x / box.length);
  };
  NearPairs near;
  std::vector<Pairs> inside(static_cast<std::size_t>(arrangement.tiles) * arrangement.tiles);
  for (std::uint32_t i = 0; i < position.size(); ++i)
    for (auto k = rows.begin(i); k < rows.end(i); ++k) {
      auto const entry = rows.entry(k);
      std::uint32_t const j = entry.index();
      if (j < i) continue;
      auto const big = static_cast<std::uint8_t>(species[i] + species[j]);
      NearPair const pair{i, j, entry.image(), big};
      Image const image = pair.image;
      // Through the edge of the box two blocks are no neighbours inside one.
      bool const straight = image.m == 0 && image.n == 0;
      bool const within = arrangement.tiles == 1 || (straight && tile(i) == tile(j));
      (within ? inside[tile(i)] : near.pairs).push_back(pair);
    }
  near.across = near.pairs.size();
  for (Pairs const& block : inside) {
    Pairs const ordered = arrangement.packs ? by_class_in_packs(block) : block;
    near.pairs.insert(near.pairs.end(), ordered.begin(), ordered.end());
  }
  return near;
}

}  // namespace bagnold::accuracy
