// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>

#include "kernels/cpu/steps/block_stepper.hpp"

namespace bagnold {

/// Prefetches the data of the next block: some cache lines for each pack of pairs of the present
/// block, so that memory and processor work at once. lines: cache lines for a pack of eight pairs.
template <int lines>
class AskAhead {
 public:
  /// near: list of pairs of the pass; halo: state that the halo copies.
  AskAhead(BlockSystem const& s, Block const& next, NearList near, BlockState const& halo)
      : AskAhead(s, next, halo.record, halo.spin) {
    add(s.now.record, next);
    add(s.trial.record, next);
    add(s.now.spin, next);
    add(s.trial.spin, next);
    add_pairs(s, next, near);
  }

  /// For pairs of the contact list. halo: array that the halo copies; own: arrays of the block.
  AskAhead(BlockSystem const& s, Block const& next, Blocks::Array<simd::Record> const& halo,
           std::initializer_list<Blocks::Array<simd::Record> const*> own)
      : AskAhead(s, next, halo, Blocks::Array<double>{}) {
    for (auto const* array : own) add(*array, next);
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
      if (s.of_pairs.extent(0) != 0)
        add(s.of_pairs.data() + 2 * block.pairs[c], 2 * block.near[contact_list][c]);
    }
  }
  template <class T>
  void add(T const* first, std::uint32_t size) {
    stretches_[count_++] = {reinterpret_cast<char const*>(first),
                            reinterpret_cast<char const*>(first + size)};
  }
};

/// Calls body(ask) for block b, which calls ask() for each pack of pairs. ask() does nothing if all
/// data are in cache. lines, of: as AskAhead has them, behind the next block.
template <int lines = 6, class Body, class... Of>
BAGNOLD_INLINE void asking_ahead(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                                 Body const& body, Of const&... of) {
  if (s.blocks.beyond_cache()) {
    auto const next = at.next != nullptr ? at.next[b] : (b + 1) % s.blocks.count;
    body(AskAhead<lines>(s, s.blocks.block(next), of...));
  } else {
    body([] {});
  }
}

}  // namespace bagnold
