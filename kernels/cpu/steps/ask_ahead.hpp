// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Prefetches the data of the next block: some cache lines for each pack of pairs of the present
/// block, so that memory and processor work at once. lines: cache lines for a pack of eight pairs.
template <int lines>
class AskAhead {
 public:
  /// Prefetches for a half of a step. near: list of pairs of this half.
  AskAhead(BlockSystem const& s, Block const& next, NearList near, BlockState const& halo)
      : AskAhead(s, next, halo.record, halo.spin) {
    add(s.now.record, next);
    add(s.trial.record, next);
    add(s.now.spin, next);
    add(s.trial.spin, next);
    add_pairs(s, next, near);
  }

  /// Prefetches for iteration k of the system's solve.
  AskAhead(BlockSystem const& s, Block const& next, int k)
      : AskAhead(s, next, s.implicit.now(k, s.trial.record), {}) {
    add(s.trial.record, next);
    if (k != 0) add(s.implicit.now(k, s.trial.record), next);
    add(s.implicit.next(k), next);
    add_pairs(s, next, contact_list);
  }

  BAGNOLD_INLINE void operator()() {
    if (halo_ != halo_end_) {
      __builtin_prefetch(halo_record_ + halo_->index(), 0, 2);
      if (halo_spin_ != nullptr) __builtin_prefetch(halo_spin_ + halo_->index(), 0, 2);
      ++halo_;
    }
    if (current_ == count_) return;
    auto& stretch = stretches_[current_];
    for (int k = 0; k < at_a_time; ++k) __builtin_prefetch(stretch.at + line * k, 0, 2);
    stretch.at += line * at_a_time;
    current_ += stretch.at >= stretch.end;
  }

 private:
  static constexpr int line = 64;  ///< [bytes]
  static constexpr int at_a_time = lines * simd::width / 8;

  AskAhead(BlockSystem const& s, Block const& next, Blocks::Array<simd::Record> const& record,
           Blocks::Array<double> const& spin)
      : halo_(s.blocks.halo.data() + next.halo_first),
        halo_end_(halo_ + next.halo),
        halo_record_(record.data()),
        halo_spin_(spin.extent(0) != 0 ? spin.data() : nullptr) {}

  struct Stretch {
    char const *at, *end;
  };
  Stretch stretches_[4 + 2 * pair_classes];
  int count_ = 0, current_ = 0;
  Neighbor const *halo_, *halo_end_;  ///< disks that its halo copies
  simd::Record const* halo_record_;
  double const* halo_spin_;

  template <class T>
  void add(Blocks::Array<T> const& of_slots, Block const& block) {
    if (of_slots.extent(0) != 0) add(of_slots.data() + block.first, block.padded);
  }
  void add_pairs(BlockSystem const& s, Block const& block, NearList near) {
    for (int c = 0; c < pair_classes; ++c) {
      add(s.blocks.near[near].data() + block.pairs[c], block.near[near][c]);
      if (s.implicit.separation.extent(0) != 0)
        add(s.implicit.separation.data() + 2 * block.pairs[c], 2 * block.near[contact_list][c]);
    }
  }
  template <class T>
  void add(T const* first, std::uint32_t size) {
    stretches_[count_++] = {reinterpret_cast<char const*>(first),
                            reinterpret_cast<char const*>(first + size)};
  }
};

/// Calls body(ask) for block b, which calls ask() for each pack of pairs. ask() does nothing if all
/// data are in cache.
template <class Body>
BAGNOLD_INLINE void asking_ahead(BlockSystem const& s, std::uint32_t b, HalfOfStep half,
                                 NearList near, Body const& body) {
  if (s.blocks.beyond_cache())
    body(AskAhead<6>(s, s.blocks.block(s.blocks.next[half](b)), near,
                     half == first_half_of_step ? s.now : s.trial));
  else
    body([] {});
}

/// Calls body(ask) in iteration k of a solve, which takes blocks in the order of their numbers.
template <class Body>
BAGNOLD_INLINE void asking_ahead(BlockSystem const& s, std::uint32_t b, int k, Body const& body) {
  if (s.blocks.beyond_cache())
    body(AskAhead<10>(s, s.blocks.block((b + 1) % s.blocks.count), k));
  else
    body([] {});
}

}  // namespace bagnold
