// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/wavefront.hpp"
#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/pruned_list.hpp"

namespace bagnold {

/// Lists of pairs that may touch, and how long they are valid: blocks along a curve with an outer
/// list, and an inner list pruned from it.
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

  /// Wraps the disks into the box and cuts them into blocks. Leaves the inner list empty.
  void build(DiskList list);

  /// Makes blocks and outer list for disks at `listed`, by default their present positions, and
  /// fills them with the disks in their present state.
  void arrange(DiskList list, std::vector<Vec2<Real>> const* listed = nullptr);

  /// Positions of the disks at the build, in the order of the start, [d_s].
  std::vector<std::array<double, 2>> at_build() const;

  /// True if a list from a mark is still valid at the next trial positions, given that no disk has
  /// moved more than `nonaffine_bound` beyond the mean flow.
  bool holds_next(ShearMark const& since, Real nonaffine_bound, Real skin) const;
  bool outer_holds(Real nonaffine_bound) const {
    return holds_next(disks_.list, nonaffine_bound, skin_);
  }
  bool inner_holds() const { return holds_next(inner.mark, inner.nonaffine_bound, inner.margin); }

  /// Prunes the inner list anew, with the margin that is best for its use.
  void prune(ListUse use);
  void fill_inner();

  /// Largest |w| since the build, [d_s]: now; and after straight flight of all disks for a
  /// duration. later: the clock at its end.
  Real farthest() const;
  Real farthest_at(std::int64_t step, Clock const& later, Real duration);

  /// Distance by which a disk may deviate from straight flights to `step`, [d_s]. farthest: largest
  /// |w| of these flights.
  Real room_at(std::int64_t step, Clock const& later, Real farthest) const;

  /// Bound of the growth of |v - gammadot y x^| in a step: the mean flow at another place differs.
  Real step_strain_factor() const {
    return 1 + std::abs(disks_.clock.strain_rate) * disks_.clock.time_step;
  }

  /// Releases and allocates the arrays that the next step can make anew.
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
