// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/steps/ask_ahead.hpp"
#include "kernels/cpu/steps/block_forces.hpp"

namespace bagnold {

/// Observer of the block's pair loop that lists the pairs of one class that touch.
struct ContactLister {
  simd::LocalPair* to;
  std::uint32_t count = 0;
  simd::Pack largest_overlap = 0.0;

  void operator()(PackOfPairs const& p) {
    count += simd::append(to + count, p.touching, p.pairs);
    largest_overlap = max(largest_overlap, zero_unless(p.touching, p.force.relative_overlap));
  }

  /// Number of pairs, after padding to whole packs with inert ones.
  std::uint32_t finish(Block const& block) const {
    for (auto k = count; k % simd::list_width != 0; ++k)
      to[k] = simd::LocalPair::make(block.own, block.own + 1);
    return count;
  }
};

/// Adds the forces of the near pairs to force, [most_local], and lists the pairs that touch for the
/// rest of the step. Returns their number and their largest overlap.
template <class Forces>
BAGNOLD_INLINE BlockReport add_and_list(Forces const& forces, BlockSystem const& s, std::uint32_t b,
                                        StepAt const& at, typename Forces::Force* force) {
  Block& block = s.blocks.block(b);
  BlockReport report;
  auto const list = [&](auto&& ask) {
    for (int c = 0; c < pair_classes; ++c) {
      ContactLister lister{s.blocks.near[contact_list].data() + block.pairs[c]};
      forces.add(c, s, block, inner_list, s.now, force, [&](PackOfPairs const& p) {
        lister(p);
        ask();
      });
      block.near[contact_list][c] = lister.finish(block);
      report.touching += block.near[contact_list][c];
      report.largest_overlap =
          std::max(report.largest_overlap, simd::largest(lister.largest_overlap));
    }
  };
  asking_ahead(s, b, at, list, inner_list, s.now);
  return report;
}

/// Copies records of disks of other blocks, and of images, into a block's halo unchanged: changes
/// of motion are equal for all images.
inline void copy_halo(Blocks const& blocks, Block const& block,
                      Blocks::Array<simd::Record> const& records) {
  auto const* halo = blocks.halo.data() + block.halo_first;
  auto* const record = records.data();
  for (std::uint32_t h = 0; h < block.halo; ++h)
    record[block.first + block.padded + h] = record[halo[h].index()];
}

}  // namespace bagnold
