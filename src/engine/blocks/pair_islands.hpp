// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/lookahead.hpp"

namespace bagnold {

/// Islands of two disks: a pack at a time, one a lane, each at its own time.
class PairIslands {
 public:
  std::vector<Islands::Pair> pairs;  ///< places in the islands' disks

  /// Steps all islands through the lookahead. Returns false if an overlap is too large or a motion
  /// NaN.
  bool run(BlockDisks const& disks, Islands const& islands, Lookahead& lookahead,
           LookaheadScratch& scratch);

 private:
  std::vector<BinaryOutcome> outcome_;  ///< by packs of pairs
};

}  // namespace bagnold
