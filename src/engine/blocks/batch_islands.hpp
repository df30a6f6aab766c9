// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/batches.hpp"
#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/lookahead.hpp"

namespace bagnold {

/// Islands of more than two disks, or of two that touch through two images: packed into batches,
/// which are stepped through a lookahead in cache, with leaps while nothing touches.
class BatchIslands {
 public:
  Islands islands;

  /// Steps all islands through the lookahead. Returns false if one is too large, an overlap too
  /// deep or a motion NaN.
  bool run(BlockDisks const& disks, Lookahead& lookahead, LookaheadScratch& scratch);

 private:
  struct Outcome {
    std::int64_t touching = 0;
    bool bad = false;
  };

  std::uint32_t slot(std::uint32_t b, std::uint32_t local) const {
    return islands.disks[islands.first_disk[batches_.stretch(b).first] + local].slot;
  }
  void add_units(LookaheadScratch& scratch);
  void run_batch(std::uint32_t b, BlockDisks const& disks, Lookahead const& lookahead,
                 LookaheadScratch& scratch, void* force);
  std::int64_t leap(std::uint32_t b, Clock const& clock, std::int64_t from, std::int64_t most,
                    std::size_t& sample, LookaheadScratch& scratch);

  Batches batches_;
  std::size_t first_unit_ = 0;
  std::vector<Outcome> outcome_;  ///< by batch
  std::vector<BlockSums> sums_;   ///< by batch, of the step that it does
};

}  // namespace bagnold
