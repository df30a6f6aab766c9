// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// Fills a near list of a block with the pairs of the list before it that are closer than d_ij +
/// margin. Their order is kept, so forces are summed in the order of the outer list whenever the
/// list is pruned.
///
/// records: of the block, halo included.
inline void prune_block(Blocks const& blocks, Block& block, NearList list,
                        simd::Record const* records, Real margin) {
  bool const first = list == inner_list;
  auto const* const wider = first ? blocks.outer.data() : blocks.near[list - 1].data();
  for (int c = 0; c < pair_classes; ++c) {
    Real const reach = class_distance(c) + margin;
    auto const* const from = wider + block.pairs[c];
    auto* const to = blocks.near[list].data() + block.pairs[c];
    auto const count = first ? block.pairs[c + 1] - block.pairs[c] : block.near[list - 1][c];
    std::uint32_t kept = 0;
    for (std::uint32_t k = 0; k < count; k += simd::width) {
      auto const d = simd::load_differences(records, from + k);
      kept +=
          simd::append(to + kept, fma(d.x, d.x, d.y * d.y) < simd::Pack(reach * reach), from + k);
    }
    block.near[list][c] = kept;
    while (kept % simd::list_width != 0)
      to[kept++] = simd::LocalPair::make(block.own, block.own + 1);
  }
}

}  // namespace bagnold
