// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/cpu/blocks/wavefront.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernels/cpu/blocks/build_blocks.hpp"
#include "tests/kernels/device/neighbors/lists.hpp"

namespace bagnold::test {
namespace {

using Space = Kokkos::DefaultHostExecutionSpace;

struct Patches {
  Blocks blocks;
  Blocks::Array<Vec2<Real>> place;
};

Patches patches(int count, double length, double offset, std::uint32_t size) {
  std::mt19937_64 random(5);
  auto const disks = anywhere(static_cast<std::size_t>(count), length, random);
  Patches made;
  made.blocks = build_blocks(Space{}, to_device<Space>("blocks::position", disks.position),
                             to_device<Space>("blocks::species", species_of(disks.diameter)),
                             make_species_table(true), {length, offset, 1e-3}, 0.35, size);
  made.place = Blocks::Array<Vec2<Real>>("neighbors::at_build", made.blocks.slots);
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    made.place(made.blocks.slot_of(i)) = {disks.position[i].x, disks.position[i].y};
  return made;
}

/// The blocks whose disks block b copies.
std::set<std::uint32_t> sources(Blocks const& blocks, std::uint32_t b) {
  std::set<std::uint32_t> found;
  Block const& block = blocks.block(b);
  for (std::uint32_t h = 0; h < block.halo; ++h) {
    auto const slot = blocks.halo(block.halo_first + h).index();
    for (std::uint32_t c = 0; c < blocks.count; ++c)
      if (slot >= blocks.block(c).first && slot < blocks.block(c).first + blocks.block(c).own)
        found.insert(c);
  }
  return found;
}

/// Goes through the stages: each block goes once through each half, and through the second one only
/// when all that it reads have been through the first. Returns for how many blocks that was in
/// their own stage or one of the `near` next ones.
int go(Blocks const& blocks, Wavefront const& wave, std::size_t near) {
  std::vector<std::size_t> stage_of(blocks.count, wave.stages.size());
  std::set<std::uint32_t> done;
  Wavefront::Stage from{0, 0};
  int soon = 0;
  for (std::size_t s = 0; s < wave.stages.size(); ++s) {
    auto const to = wave.stages[s];
    for (auto k = from.first_half; k < to.first_half; ++k) {
      EXPECT_EQ(stage_of.at(wave.first_half.at(k)), wave.stages.size()) << "twice";
      stage_of[wave.first_half[k]] = s;
    }
    for (auto k = from.second_half; k < to.second_half; ++k) {
      auto const b = wave.second_half.at(k);
      EXPECT_TRUE(done.insert(b).second) << "twice";
      EXPECT_LE(stage_of[b], s);
      for (auto const c : sources(blocks, b)) EXPECT_LE(stage_of[c], s) << b << " reads " << c;
      soon += s - stage_of[b] <= near;
    }
    from = to;
  }
  EXPECT_EQ(done.size(), blocks.count);
  return soon;
}

TEST(Wavefront, SecondHalvesWaitForAllThatTheyRead) {
  for (auto const& [count, length, size] :
       {std::tuple{40, 5.0, 64u}, {700, 26.0, 64u}, {3000, 55.0, 32u}})
    for (double const turn : {0.0, 0.37})
      for (std::uint32_t const at_once : {1u, 3u, 10u, 1000u}) {
        auto const [blocks, place] = patches(count, length, turn * length, size);
        Wavefront const wave(blocks, place, at_once);
        EXPECT_EQ(wave.stages.size(), (blocks.count + at_once - 1) / at_once);
        go(blocks, wave, 0);
      }
}

/// A block comes back while it is in cache: rows of blocks follow each other across the box, and
/// but for the first row, which waits for the last, none waits for more than the one above it.
TEST(Wavefront, SecondHalvesFollowOneRowBehind) {
  auto const [blocks, place] = patches(6400, 80.0, 11.0, 25);  // 16 x 16 blocks
  ASSERT_EQ(blocks.count, 256u);
  Wavefront const wave(blocks, place, 16);
  EXPECT_GE(go(blocks, wave, 2), 256 - 2 * 16);
}

}  // namespace
}  // namespace bagnold::test
