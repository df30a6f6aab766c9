// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/wavefront.hpp"
#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/pruned_list.hpp"

namespace bagnold {

/// Which pairs of disks may touch: blocks along a curve with an outer list, and an inner one pruned
/// from it; and how long they hold.
class BlockLists {
 public:
  Real fastest = 0;                ///< largest peculiar speed now, or a bound, [d_s/tau_e]
  Real outer_nonaffine_bound = 0;  ///< at least the largest |w| since the build, [d_s]
  PrunedList inner;
  std::uint64_t near_pairs = 0;  ///< in the inner list when it was pruned
  std::int64_t builds = 0;

  BlockLists(BlockDisks& disks, Real skin) : disks_(disks), skin_(skin) {}

  Real skin() const { return skin_; }
  Wavefront const& wavefront() const { return wavefront_; }

  /// Takes the disks into the box and cuts them into blocks; the inner list is still missing.
  void build(DiskList list);

  /// Blocks and outer list of disks at `listed`, by default where they are now, filled with the
  /// disks as they are now.
  void arrange(DiskList list, std::vector<Vec2<Real>> const* listed = nullptr);

  /// Where the disks were at the build, in the order of the start, [d_s].
  std::vector<std::array<double, 2>> at_build() const;

  /// Whether a list from a mark still holds for the next trial positions, if no disk has moved
  /// more than `nonaffine_bound` beyond the mean flow.
  bool holds_next(ShearMark const& since, Real nonaffine_bound, Real skin) const;
  bool outer_holds(Real nonaffine_bound) const {
    return holds_next(disks_.list, nonaffine_bound, skin_);
  }
  bool inner_holds() const { return holds_next(inner.mark, inner.nonaffine_bound, inner.margin); }

  /// Takes the inner list anew, with the margin that suits its use best.
  void prune(ListUse use);
  void fill_inner();

  /// Largest |w| since the build now, and at a later step if all disks fly straight until then, for
  /// so long, [d_s]. later: the clock there.
  Real farthest() const;
  Real farthest_at(std::int64_t step, Clock const& later, Real duration);

  /// How far a disk may still deviate from straight flights to `step`, whose farthest |w| that is,
  /// [d_s].
  Real room_at(std::int64_t step, Clock const& later, Real farthest) const;

  /// |v - gammadot y x^| as it may be about the mean flow at another place a step on, over what it
  /// is.
  Real step_strain_factor() const {
    return 1 + std::abs(disks_.clock.strain_rate) * disks_.clock.time_step;
  }

  /// What the next step can make anew: given back, and taken again.
  void give_back_scratch();
  void take_scratch();

 private:
  void make_trial();
  void make_inert(Block const& block);
  std::uint32_t blocks_at_once() const;
  Blocks::Array<std::uint32_t> next_in(std::vector<std::uint32_t> const& order);

  BlockDisks& disks_;
  Real skin_;
  Wavefront wavefront_;
  Blocks::Array<Vec2<Real>> at_build_;  ///< by slot
  std::vector<Real> far2_;              ///< by block
};

}  // namespace bagnold
