// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// Order in which blocks go through both halves of a step in one pass through memory.
///
/// The second half of a block needs the first half of every block that its halo copies, and of no
/// other. Blocks are therefore taken across the box from one side to the other, in groups. A group
/// goes through the first half; then the blocks that no longer wait for others go through the
/// second half. These are about a row of blocks behind and still in cache.
class Wavefront {
 public:
  /// Ends of a stage in the orders of the two halves.
  struct Stage {
    std::uint32_t first_half, second_half;
  };

  std::vector<std::uint32_t> first_half,
      second_half;  ///< [blocks.count]: blocks in the order of each half
  std::vector<Stage> stages;

  Wavefront() = default;

  /// place: [slots], positions of disks; `at_once`: blocks in a stage.
  Wavefront(Blocks const& blocks, Blocks::Array<Vec2<Real>> const& place, std::uint32_t at_once)
      : first_half(across(blocks, place)) {
    auto const last = awaited(blocks);
    second_half = first_half;
    std::stable_sort(second_half.begin(), second_half.end(),
                     [&](auto a, auto b) { return last[a] < last[b]; });
    Stage stage{0, 0};
    while (stage.first_half < blocks.count) {
      stage.first_half = std::min(stage.first_half + at_once, blocks.count);
      while (stage.second_half < blocks.count &&
             last[second_half[stage.second_half]] < stage.first_half)
        ++stage.second_half;
      stages.push_back(stage);
    }
  }

 private:
  /// Blocks by the mean height of their disks.
  static std::vector<std::uint32_t> across(Blocks const& blocks,
                                           Blocks::Array<Vec2<Real>> const& place) {
    std::vector<Real> height(blocks.count);
    for (std::uint32_t b = 0; b < blocks.count; ++b) {
      Block const& block = blocks.block(b);
      for (std::uint32_t i = 0; i < block.own; ++i)
        height[b] += place(block.first + i).y / block.own;
    }
    std::vector<std::uint32_t> order(blocks.count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return height[a] < height[b]; });
    return order;
  }

  /// Last block, in the order of the first half, that each block waits for.
  std::vector<std::uint32_t> awaited(Blocks const& blocks) const {
    std::vector<std::uint32_t> rank(blocks.count), first_slot(blocks.count);
    for (std::uint32_t k = 0; k < blocks.count; ++k) rank[first_half[k]] = k;
    for (std::uint32_t b = 0; b < blocks.count; ++b) first_slot[b] = blocks.block(b).first;
    auto const owner = [&](std::uint32_t slot) {
      auto const behind = std::upper_bound(first_slot.begin(), first_slot.end(), slot);
      return static_cast<std::uint32_t>(behind - first_slot.begin()) - 1;
    };
    auto last = rank;
    for (std::uint32_t b = 0; b < blocks.count; ++b) {
      Block const& block = blocks.block(b);
      for (std::uint32_t h = 0; h < block.halo; ++h)
        last[b] = std::max(last[b], rank[owner(blocks.halo(block.halo_first + h).index())]);
    }
    return last;
  }
};

}  // namespace bagnold
