// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/forecast_list.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/cpu/blocks/prune.hpp"
#include "kernels/cpu/islands/free_flight.hpp"
#include "kernels/physics/box/list_criterion.hpp"

namespace bagnold {

namespace {

/// Cost of keeping a pair in a pruned list over that of a prediction for it.
constexpr Real pruning_cost = 0.25;

}  // namespace

void ForecastList::renew(Lookahead const& lookahead, ShearedBox const& box, Real duration,
                         Real allowance) {
  if (is_pruned() && margin_for(lookahead, farthest(lookahead, duration) + allowance) < margin_)
    return;
  mark_here();
  Real const moved = farthest(lookahead, duration);
  // A list of margin m has a share m/skin of the outer pairs and holds for (m - 2 allowance)/2
  // moved lookaheads.
  Real const least = 1.1 * margin_for(lookahead, moved + allowance);
  margin_ = std::max(least, 2 * allowance + std::sqrt(2 * moved * skin_ * pruning_cost));
  if (margin_ < skin_ / 2)
    prune(box);
  else
    listing_ = -1;
}

void ForecastList::mark_here() {
  auto const& system = disks_.system;
  mark_ = disks_.clock.mark(system.step);
  at_mark_.resize(system.blocks.slots);
  (*disks_.loop)(system.blocks.count, [&](std::uint32_t b) {
    Block const& block = system.blocks.block(b);
    for (auto slot = block.first; slot < block.first + block.padded; ++slot) {
      auto const& r = system.now.record(slot);
      at_mark_[slot] = {r.x, r.y};
    }
  });
}

void ForecastList::prune(ShearedBox const& box) {
  auto& system = disks_.system;
  (*disks_.loop)(system.blocks.count, [&](std::uint32_t b) {
    Block& block = system.blocks.block(b);
    refresh_halo(system.blocks, block, system.now, box);
    prune_block(system.blocks, block, inner_list, system.now.record.data() + block.first, margin_);
  });
  listing_ = ++system.listing;
}

/// Largest |w| since the mark at both ends of the lookahead, between which it is not larger, [d_s].
Real ForecastList::farthest(Lookahead const& lookahead, Real duration) {
  auto const& system = disks_.system;
  Real const begin = disks_.clock.strain_since(mark_, lookahead.begin),
             end = lookahead.after.strain_since(mark_, lookahead.end);
  far2_.assign(system.blocks.count, 0);
  (*disks_.loop)(system.blocks.count, [&](std::uint32_t b) {
    Block const& block = system.blocks.block(b);
    auto const* const records = system.now.record.data() + block.first;
    auto const* const from = at_mark_.data() + block.first;
    far2_[b] = std::max(farthest2_after(block, records, from, 0, begin),
                        farthest2_after(block, records, from, duration, end));
  });
  return std::sqrt(*std::max_element(far2_.begin(), far2_.end()));
}

/// Margin that a list needs if disks are at most `farthest` from the mark at the end of the
/// lookahead, [d_s].
Real ForecastList::margin_for(Lookahead const& lookahead, Real farthest) const {
  return list_margin(lookahead.after.strain_since(mark_, lookahead.end), farthest);
}

}  // namespace bagnold
