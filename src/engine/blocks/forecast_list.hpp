// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/cpu/islands/predict_contacts.hpp"
#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/lookahead.hpp"

namespace bagnold {

/// Pairs from which lookaheads predict contacts: those of the outer list, or a shorter list pruned
/// from it, which is valid for several lookaheads and takes the place of the inner list. Forecasts
/// are the same from both.
class ForecastList {
 public:
  /// skin: of the outer list, [d_s].
  ForecastList(BlockDisks& disks, Real skin) : disks_(disks), skin_(skin) {}

  /// Renews the list unless it holds every pair that touches on the lookahead's straight flights,
  /// of `duration`, or would touch if each disk deviated from these by up to `allowance`, [d_s].
  void renew(Lookahead const& lookahead, ShearedBox const& box, Real duration, Real allowance);

  ListedPairs of(Block const& block) const {
    return is_pruned() ? near_pairs(disks_.system.blocks, block, inner_list)
                       : outer_pairs(disks_.system.blocks, block);
  }

 private:
  bool is_pruned() const { return listing_ == disks_.system.listing; }
  void mark_here();
  void prune(ShearedBox const& box);
  Real farthest(Lookahead const& lookahead, Real duration);
  Real margin_for(Lookahead const& lookahead, Real farthest) const;

  BlockDisks& disks_;
  Real skin_;
  std::int64_t listing_ = -1;        ///< of the system, when the list was pruned
  ShearMark mark_;                   ///< then
  Real margin_ = 0;                  ///< pairs up to d_ij + margin are in it, [d_s]
  std::vector<Vec2<Real>> at_mark_;  ///< by slot, [d_s]
  std::vector<Real> far2_;           ///< by block, [d_s^2]
};

}  // namespace bagnold
