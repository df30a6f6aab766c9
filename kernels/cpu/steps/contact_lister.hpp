// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_forces.hpp"

namespace bagnold {

/// Lists the pairs of one class that touch, as an observer of the block's pair loop.
struct ContactLister {
  simd::LocalPair* to;
  std::uint32_t count = 0;
  simd::Pack largest_overlap = 0.0;

  void operator()(PackOfPairs const& p) {
    count += simd::append(to + count, p.touching, p.pairs);
    largest_overlap = max(largest_overlap, zero_unless(p.touching, p.force.relative_overlap));
  }

  /// The number of pairs, filled up to packs with inert ones.
  std::uint32_t finish(Block const& block) const {
    for (auto k = count; k % simd::list_width != 0; ++k)
      to[k] = simd::LocalPair::make(block.own, block.own + 1);
    return count;
  }
};

/// Copies records of disks of other blocks, and images, into a block's halo as they are: changes of
/// motion are the same for all images.
inline void copy_halo(Blocks const& blocks, Block const& block,
                      Blocks::Array<simd::Record> const& records) {
  auto const* halo = blocks.halo.data() + block.halo_first;
  auto* const record = records.data();
  for (std::uint32_t h = 0; h < block.halo; ++h)
    record[block.first + block.padded + h] = record[halo[h].index()];
}

}  // namespace bagnold
