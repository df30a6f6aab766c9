// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/blocks/blocks.hpp"

namespace bagnold {

/// Fills a block's inner list with the outer pairs closer than d_ij + margin, in their order: so
/// forces are summed in the order of the outer list, whenever it was pruned.
///
/// records: the block's, halo included.
inline void prune_block(Blocks const& blocks, Block& block, simd::Record const* records,
                        Real margin) {
  for (int c = 0; c < pair_classes; ++c) {
    Real const reach = class_distance(c) + margin;
    auto const* outer = blocks.outer.data();
    auto* const inner = blocks.inner.data() + block.pairs[c];
    std::uint32_t kept = 0;
    for (auto k = block.pairs[c]; k < block.pairs[c + 1]; k += simd::width) {
      auto const d = simd::load_differences(records, outer + k);
      kept += simd::append(inner + kept, fma(d.x, d.x, d.y * d.y) < simd::Pack(reach * reach),
                           outer + k);
    }
    block.inner[c] = kept;
    while (kept % simd::width != 0)
      inner[kept++] = simd::LocalPair::make(block.own, block.own + 1);
  }
}

}  // namespace bagnold
