// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Asks for what the next block's half of a step goes through, some lines for each pack of pairs of
/// the block at work, so that memory and processor work at once.
class AskAhead {
 public:
  /// near: the list of pairs that this half goes through.
  AskAhead(BlockSystem const& s, Block const& next, NearList near) {
    add(s.now.record, next);
    add(s.trial.record, next);
    add(s.now.spin, next);
    add(s.trial.spin, next);
    for (int c = 0; c < pair_classes; ++c)
      add(s.blocks.near[near].data() + next.pairs[c], next.near[near][c]);
  }

  BAGNOLD_INLINE void operator()() {
    if (current_ == count_) return;
    auto& stretch = stretches_[current_];
    for (int k = 0; k < lines; ++k) __builtin_prefetch(stretch.at + line * k, 0, 2);
    stretch.at += line * lines;
    current_ += stretch.at >= stretch.end;
  }

 private:
  static constexpr int line = 64;  ///< [bytes]
  /// In a pack; of eight pairs: 8 and 4 cost more.
  static constexpr int lines = 6 * simd::width / 8;

  struct Stretch {
    char const *at, *end;
  };
  Stretch stretches_[4 + pair_classes];
  int count_ = 0, current_ = 0;

  template <class T>
  void add(Blocks::Array<T> const& of_slots, Block const& block) {
    if (of_slots.extent(0) != 0) add(of_slots.data() + block.first, block.padded);
  }
  template <class T>
  void add(T const* first, std::uint32_t size) {
    stretches_[count_++] = {reinterpret_cast<char const*>(first),
                            reinterpret_cast<char const*>(first + size)};
  }
};

/// body(ask), ask() to be called for each pack of pairs of block b; where all is in cache it does
/// nothing.
template <class Body>
BAGNOLD_INLINE void asking_ahead(BlockSystem const& s, std::uint32_t b, HalfOfStep half,
                                 NearList near, Body const& body) {
  if (s.blocks.beyond_cache())
    body(AskAhead(s, s.blocks.block(s.blocks.next[half](b)), near));
  else
    body([] {});
}

}  // namespace bagnold
