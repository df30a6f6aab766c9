// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/blocks/prune.hpp"
#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Disks that touch others, block by block. Steps with few contacts evaluate forces for these
/// alone.
struct ActiveDisks {
  Blocks::Array<std::uint16_t> list;      ///< [slots], by block: four times the index of each
  Blocks::Array<std::uint8_t> is_active;  ///< [slots]
  Blocks::Array<std::uint32_t> count;     ///< [blocks], in `list`

  /// Allocates arrays for new blocks in which no disk is active. loop: makes cleared memory.
  template <class Loop>
  void resize(Loop& loop, Blocks& blocks) {
    blocks.make_room(contact_list, "steps::contacts");
    if (list.extent(0) < blocks.slots) {
      list = {};
      is_active = {};
      list = loop.template zeros<std::uint16_t>("steps::active", blocks.slots);
      is_active = loop.template zeros<std::uint8_t>("steps::is_active", blocks.slots);
    }
    if (count.extent(0) < blocks.count)
      count = loop.template zeros<std::uint32_t>("steps::active_count", blocks.count);
    loop(blocks.count, [&](std::uint32_t b) {
      Block const& block = blocks.block(b);
      std::fill_n(is_active.data() + block.first, block.local(), std::uint8_t{0});
    });
  }

  /// Lists the pairs of block b that touch, adds their disks to the active ones and clears the
  /// forces on these.
  template <class Force>
  void find(Blocks const& blocks, std::uint32_t b, simd::Record const* records,
            Force* force) const {
    Block& block = blocks.block(b);
    prune_block(blocks, block, contact_list, records, 0);
    auto* const active = list.data() + block.first;
    auto* const marked = is_active.data() + block.first;
    auto n = count(b);
    auto const add = [&](std::uint16_t at) {
      auto const i = at / 4u;
      force[i] = Force{};
      active[n] = at;
      n += static_cast<std::uint32_t>(i < block.own) & (marked[i] ^ 1u);  // branchless
      marked[i] = 1;  // halo disks too, which stay marked
    };
    for (std::uint32_t k = 0; k < count(b); ++k) simd::at(force, active[k]) = Force{};
    for (int c = 0; c < pair_classes; ++c) {
      auto const* pairs = blocks.near[contact_list].data() + block.pairs[c];
      for (std::uint32_t k = 0; k < block.near[contact_list][c]; ++k) {
        add(pairs[k].a4);
        add(pairs[k].b4);
      }
    }
    count(b) = n;
    auto const inert = static_cast<std::uint16_t>(4 * block.own);
    force[block.own] = force[block.own + 1] = Force{};
    for (auto k = n; k < simd::round_up(n); ++k) active[k] = inert;
  }

  /// Calls body(at, big) for a pack of active disks at a time; the last ones are inert.
  template <class Body>
  void each_pack(Block const& block, std::uint32_t n, Species const* species,
                 Body const& body) const {
    auto const* const active = list.data() + block.first;
    for (std::uint32_t k = 0; k < n; k += simd::width) {
      unsigned big = 0;
      for (int j = 0; j < simd::width; ++j)
        big |= static_cast<unsigned>(species[block.first + active[k + j] / 4u]) << j;
      body(active + k, simd::Mask::of(big));
    }
  }
};

}  // namespace bagnold
