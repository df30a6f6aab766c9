// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "kernels/cpu/blocks/build_blocks.hpp"
#include "kernels/cpu/blocks/prune.hpp"
#include "kernels/cpu/steps/predict_correct_block_step.hpp"
#include "tests/kernels/device/neighbors/lists.hpp"

namespace bagnold::test {
namespace {

using Space = Kokkos::DefaultHostExecutionSpace;

TEST(SpatialOrder, HilbertCurveStepsFromCellToCell) {
  for (int level : {1, 2, 5}) {
    std::uint32_t const side = 1u << level;
    std::map<std::uint64_t, std::pair<int, int>> cell_of;
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) cell_of[hilbert_index(level, x, y)] = {x, y};
    ASSERT_EQ(cell_of.size(), side * side);
    ASSERT_EQ(cell_of.rbegin()->first, side * side - 1);
    for (std::uint64_t k = 1; k < side * side; ++k) {
      auto const [x, y] = cell_of[k];
      auto const [u, v] = cell_of[k - 1];
      EXPECT_EQ(std::abs(x - u) + std::abs(y - v), 1) << level << " at " << k;
    }
  }
}

TEST(SpatialOrder, HasEveryCellOnce) {
  constexpr std::pair<int, int> shapes[] = {{1, 1},   {2, 2},  {3, 3}, {7, 7},
                                            {33, 33}, {3, 40}, {21, 2}};
  for (auto const& [columns, rows] : shapes) {
    auto const order = cells_along_curve(columns, rows);
    std::set<std::uint32_t> const all(order.begin(), order.end());
    EXPECT_EQ(order.size(), static_cast<std::size_t>(columns * rows));
    EXPECT_EQ(all.size(), order.size());
    EXPECT_EQ(*all.rbegin(), static_cast<std::uint32_t>(columns * rows - 1));
  }
}

/// Every pair image near enough is in the lists of both its disks' blocks, once, at the right class
/// and the right place; nothing else is.
TEST(Blocks, HoldEveryPairWhereItBelongs) {
  std::mt19937_64 random(3);
  double const skin = 0.35, rate = 1e-3;
  struct Case {
    int count;
    double length, height;
  };
  for (auto const& [count, length, height] : {Case{20, 3.6, 3.6},
                                              {60, 7.0, 7.0},
                                              {700, 26.0, 26.0},
                                              {700, 6.5, 104.0},
                                              {700, 104.0, 6.5}})
    for (double const turn : {0.0, 0.3, 0.999999}) {
      double const offset = turn * length;
      ShearedBox const box{length, offset, rate, height};
      auto const disks = anywhere(static_cast<std::size_t>(count), box, random);
      auto const table = make_species_table(true);
      auto const species = species_of(disks.diameter);
      auto const blocks =
          build_blocks(Space{}, to_device<Space>("blocks::position", disks.position),
                       to_device<Space>("blocks::species", species), table, box, skin, 64);

      BlockState state{Blocks::Array<simd::Record>("state::record", blocks.slots), {}};
      std::map<std::uint32_t, std::uint32_t> disk_at;
      for (std::uint32_t i = 0; i < disks.count(); ++i) {
        auto const slot = blocks.slot_of(i);
        ASSERT_TRUE(disk_at.emplace(slot, i).second);
        state.record(slot) = {disks.position[i].x, disks.position[i].y, 0.1 * i, -0.2 * i};
      }
      Rows found(disks.count());
      for (std::uint32_t b = 0; b < blocks.count; ++b) {
        Block const& block = blocks.block(b);
        EXPECT_EQ(block.own,
                  std::min<std::uint32_t>(64, static_cast<std::uint32_t>(count) - 64 * b));
        refresh_halo(blocks, block, state, box);
        auto const* record = state.record.data() + block.first;
        for (int c = 0; c < pair_classes; ++c)
          for (auto k = block.pairs[c]; k < block.pairs[c + 1]; ++k) {
            auto const pair = blocks.outer(k);
            auto const low = std::min(pair.a(), pair.b()), high = std::max(pair.a(), pair.b());
            if (low == block.own && high == block.own + 1) continue;  // filling
            ASSERT_LT(low, block.own);
            auto const i = disk_at.at(block.first + low);
            Neighbor neighbor = Neighbor::make(block.first + high, {});
            if (high >= block.padded)
              neighbor = blocks.halo(block.halo_first + high - block.padded);
            else
              ASSERT_LT(high, block.own);
            auto const j = disk_at.at(neighbor.index());
            Image const image = neighbor.image();
            EXPECT_EQ(pair_class(species[i], species[j]), c);
            if (c == 1) {  // small first
              EXPECT_EQ(species[pair.a() == low ? i : j], 0);
            }
            EXPECT_EQ(record[high].x, disks.position[j].x + box.shift(image).x);
            EXPECT_EQ(record[high].y, disks.position[j].y + box.shift(image).y);
            EXPECT_EQ(record[high].vx, 0.1 * j + box.velocity_shift(image));
            found[i].push_back({j, image.m, image.n});
            if (high < block.padded) found[j].push_back({i, -image.m, -image.n});
          }
      }
      for (auto& row : found) std::sort(row.begin(), row.end());
      EXPECT_EQ(found, all_pairs(disks, box, skin)) << count << " disks, offset " << offset;
    }
}

/// A pruned list is the outer one without the pairs that are too far, in its order.
TEST(Blocks, PruningLeavesTheNearPairsInTheirOrder) {
  std::mt19937_64 random(4);
  double const length = 26.0, margin = 0.1;
  auto const disks = anywhere(700, length, random);
  ShearedBox const box{length, 5.0, 1e-3};
  auto const blocks = build_blocks(Space{}, to_device<Space>("blocks::position", disks.position),
                                   to_device<Space>("blocks::species", species_of(disks.diameter)),
                                   make_species_table(true), box, 0.35, 256);
  BlockState state{Blocks::Array<simd::Record>("state::record", blocks.slots), {}};
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block const& block = blocks.block(b);
    for (auto i = block.own; i < block.padded; ++i)
      state.record(block.first + i) = {1e3 * length * (i - block.own + 1), 0, 0, 0};
  }
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    state.record(blocks.slot_of(i)) = {disks.position[i].x, disks.position[i].y, 0, 0};
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block& block = blocks.block(b);
    refresh_halo(blocks, block, state, box);
    auto const* record = state.record.data() + block.first;
    prune_block(blocks, block, inner_list, record, margin);
    for (int c = 0; c < pair_classes; ++c) {
      std::vector<std::uint32_t> expected, kept;
      auto const name = [](simd::LocalPair p) { return p.a() << 16 | p.b(); };
      for (auto k = block.pairs[c]; k < block.pairs[c + 1]; ++k) {
        auto const p = blocks.outer(k);
        auto const &u = record[p.a()], &v = record[p.b()];
        if (std::hypot(u.x - v.x, u.y - v.y) < class_distance(c) + margin)
          expected.push_back(name(p));
      }
      for (std::uint32_t k = 0; k < block.near[inner_list][c]; ++k)
        kept.push_back(name(blocks.near[inner_list](block.pairs[c] + k)));
      EXPECT_EQ(kept, expected);
      EXPECT_GT(kept.size(), 10u);
      EXPECT_LT(kept.size(), block.pairs[c + 1] - block.pairs[c]);
    }
  }
}

}  // namespace
}  // namespace bagnold::test
