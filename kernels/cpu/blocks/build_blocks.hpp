// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include "kernels/cpu/blocks/blocks.hpp"
#include "kernels/cpu/blocks/most_pairs.hpp"
#include "kernels/cpu/blocks/spatial_order.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/device/side_by_side.hpp"

namespace bagnold {

namespace detail {

/// Disk indices in the order of the curve; disks of one cell in the order of their index.
template <class Space>
std::vector<std::uint32_t> disks_along_curve(CellGrid<Space> const& grid) {
  std::vector<std::uint32_t> order;
  order.reserve(grid.members.extent(0));
  for (std::uint32_t const cell : cells_along_curve(grid.columns, grid.rows))
    for (auto k = grid.first(cell); k < grid.first(cell + 1); ++k) order.push_back(grid.members(k));
  return order;
}

/// Pairs of a block in the order in which they are found.
struct FoundPairs {
  std::vector<Neighbor> partner;
  std::vector<std::uint32_t> end;  ///< of each own disk's, in `partner`
};

/// Reorders pairs so that pairs of one disk lie a pack apart. Consecutive packs then add forces to
/// different disks and need not wait for each other's stores. Works within stretches that stay in
/// the first-level cache.
inline void interleave(simd::LocalPair* pairs, std::uint32_t count) {
  constexpr std::uint32_t width = simd::list_width, stretch = 8 * width;
  simd::LocalPair moved[stretch];
  for (std::uint32_t begin = 0; begin < count; begin += stretch) {
    std::uint32_t const packs = std::min(stretch, count - begin) / width;
    for (std::uint32_t k = 0; k < packs * width; ++k)
      moved[k % packs * width + k / packs] = pairs[begin + k];
    std::copy(moved, moved + packs * width, pairs + begin);
  }
}

}  // namespace detail

/// Cuts disks into blocks of `size` along a Hilbert curve and lists their pairs within d_ij + skin.
///
/// position: [N], in the box, [d_s]; box.offset in [0, L_x). Depends on positions alone: neither on
/// threads nor on an earlier order. Scratch of about 60 bytes a disk is freed on return.
template <class Space>
Blocks build_blocks(Space const& space, Kokkos::View<Vec2<Real>*, Space> const& position,
                    Kokkos::View<Species*, Space> const& species, SpeciesTable const& table,
                    ShearedBox const& box, Real skin, std::uint32_t size) {
  using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;
  auto const count = static_cast<std::uint32_t>(position.extent(0));
  Real const reach = big_diameter + skin;
  auto const order = detail::disks_along_curve(make_cell_grid(space, position, box, reach));

  // All arrays below are ordered by rank along the curve.
  Kokkos::View<Vec2<Real>*, Space> place("blocks::place", count);
  Kokkos::View<Species*, Space> kind("blocks::kind", count);
  for (std::uint32_t rank = 0; rank < count; ++rank) {
    place(rank) = position(order[rank]);
    kind(rank) = species(order[rank]);
  }
  NeighborSearch<Space> const search{place, kind, make_cell_grid(space, place, box, reach),
                                     table, box,  skin};

  Blocks blocks;
  blocks.count = (count + size - 1) / size;
  blocks.block = Blocks::Array<Block>(Kokkos::view_alloc(space, "blocks::block"), blocks.count);
  auto const block = blocks.block;
  auto const is_inside = [=](std::uint32_t b, Neighbor const& n) {
    return n.index() - b * size < size && n.image().m == 0 && n.image().n == 0;
  };

  // Pairs ordered by disk; then halos and pair counts of each block.
  std::vector<detail::FoundPairs> found(blocks.count);
  std::vector<std::vector<std::uint32_t>> keys(blocks.count);
  side_by_side::parallel_for("blocks::count", Policy(space, 0, blocks.count), [&](std::int64_t b) {
    Block mine;
    auto const begin = static_cast<std::uint32_t>(b) * size;
    mine.own = std::min(count - begin, size);
    mine.padded = simd::round_up(mine.own + 2);
    auto& halo = keys[b];
    auto& listed = found[b];
    listed.end.reserve(mine.own);
    listed.partner.reserve(5 * mine.own);
    for (auto i = begin; i < begin + mine.own; ++i) {
      search(i, [&](Neighbor const& n) {
        bool const inside = is_inside(b, n);
        if (inside && n.index() < i) return;
        ++mine.pairs[pair_class(kind(i), kind(n.index()))];
        listed.partner.push_back(n);
        if (!inside) halo.push_back(n.packed);
      });
      listed.end.push_back(static_cast<std::uint32_t>(listed.partner.size()));
    }
    std::sort(halo.begin(), halo.end());
    halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
    mine.halo = static_cast<std::uint32_t>(halo.size());
    block(b) = mine;
  });

  std::uint64_t slots = 0, pairs = 0, halos = 0;
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block& mine = block(b);
    if (mine.local() > simd::LocalPair::max_count)
      throw std::length_error("a block has more disks and images than its pairs can name");
    mine.first = static_cast<std::uint32_t>(slots);
    mine.halo_first = static_cast<std::uint32_t>(halos);
    slots += simd::round_up(mine.local());
    halos += mine.halo;
    for (int c = 0; c <= pair_classes; ++c) {
      auto const held = simd::round_up(mine.pairs[c]);
      mine.pairs[c] = static_cast<std::uint32_t>(pairs);
      if (c < pair_classes) pairs += held;
    }
    blocks.most_local = std::max(blocks.most_local, simd::round_up(mine.local()));
  }
  if (slots >= Neighbor::max_count || pairs >= most_pairs)
    throw std::length_error("too many disks for one process");
  blocks.slots = static_cast<std::uint32_t>(slots);

  blocks.halo = Blocks::room<Neighbor>("blocks::halo", halos);
  blocks.outer = Blocks::room<simd::LocalPair>("blocks::outer", pairs);
  blocks.near[inner_list] = Blocks::room<simd::LocalPair>("blocks::inner", pairs);
  blocks.slot_of = Blocks::room<std::uint32_t>("blocks::slot_of", count);
  auto const slot = [=](std::uint32_t rank) { return block(rank / size).first + rank % size; };
  for (std::uint32_t rank = 0; rank < count; ++rank) blocks.slot_of(order[rank]) = slot(rank);

  side_by_side::parallel_for("blocks::fill", Policy(space, 0, blocks.count), [&](std::int64_t b) {
    Block const& mine = block(b);
    auto const begin = static_cast<std::uint32_t>(b) * size;
    auto const& halo = keys[b];
    for (std::uint32_t h = 0; h < mine.halo; ++h) {
      Neighbor const n{halo[h]};
      blocks.halo(mine.halo_first + h) = Neighbor::make(slot(n.index()), n.image());
    }
    std::uint32_t end[pair_classes] = {mine.pairs[0], mine.pairs[1], mine.pairs[2]};
    auto const& listed = found[b];
    for (std::uint32_t i = 0, k = 0; i < mine.own; ++i)
      for (; k < listed.end[i]; ++k) {
        Neighbor const n = listed.partner[k];
        auto const partner =
            is_inside(b, n)
                ? n.index() - begin
                : mine.padded +
                      static_cast<std::uint32_t>(
                          std::lower_bound(halo.begin(), halo.end(), n.packed) - halo.begin());
        auto const mine_is = kind(begin + i), other_is = kind(n.index());
        blocks.outer(end[pair_class(mine_is, other_is)]++) =
            mine_is > other_is ? simd::LocalPair::make(partner, i)
                               : simd::LocalPair::make(i, partner);
      }
    found[b] = {};
    for (int c = 0; c < pair_classes; ++c) {
      while (end[c] < mine.pairs[c + 1])
        blocks.outer(end[c]++) = simd::LocalPair::make(mine.own, mine.own + 1);
      detail::interleave(blocks.outer.data() + mine.pairs[c], mine.pairs[c + 1] - mine.pairs[c]);
    }
  });
  return blocks;
}

}  // namespace bagnold
