// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// A pair of disks by slot, with the image of the second one that the first may meet.
struct SlotPair {
  std::uint32_t a;
  Neighbor b;
};

/// Pair of slots of a local pair of a block.
inline SlotPair slot_pair(Blocks const& blocks, Block const& block, simd::LocalPair const& pair) {
  auto const own = std::min(pair.a(), pair.b()), other = std::max(pair.a(), pair.b());
  if (other < block.padded) return {block.first + own, Neighbor::make(block.first + other, {})};
  return {block.first + own, blocks.halo(block.halo_first + other - block.padded)};
}

/// True for one of the two listings of a pair across the edge of a block, which both blocks list.
inline bool is_first_listing(SlotPair const& pair) { return pair.a < pair.b.index(); }

/// Pairs of a pack that come closer than `reach` on straight flights of `duration`.
///
/// With r the separation, v the relative velocity, b = r.v and c = r^2 - reach^2: close at the
/// start if c < 0, at the end if c + 2 b T + v^2 T^2 < 0, in between if b < 0, -b < v^2 T and v^2 c
/// < b^2.
BAGNOLD_INLINE simd::Mask may_meet(simd::Records const& d, simd::Pack reach, simd::Pack duration) {
  using simd::Pack;
  Pack const b = fma(d.x, d.vx, d.y * d.vy);
  Pack const c = fma(d.x, d.x, fma(d.y, d.y, -(reach * reach)));
  Pack const v2 = fma(d.vx, d.vx, d.vy * d.vy);
  Pack const end = fma(duration, fma(v2, duration, b + b), c);
  Pack const zero = 0.0;
  return (c < zero) | (end < zero) | ((b < zero) & (-b < v2 * duration) & (v2 * c < b * b));
}

/// Pairs that may meet within a lookahead, each once over all blocks.
struct Forecast {
  std::vector<SlotPair> meeting;  ///< on straight flights
  struct Near {
    SlotPair pair;
    int deviating;  ///< how many of the two must deviate by the usual for it: 1, 2, or 3 if that is
                    ///< not enough
  };
  std::vector<Near> near;  ///< only if disks deviate from these by up to the allowance

  void clear() {
    meeting.clear();
    near.clear();
  }
};

/// Pairs of a block by class, each class padded to a multiple of eight.
struct ListedPairs {
  simd::LocalPair const* first[pair_classes];
  std::uint32_t count[pair_classes];
};

inline ListedPairs outer_pairs(Blocks const& blocks, Block const& block) {
  ListedPairs list;
  for (int c = 0; c < pair_classes; ++c) {
    list.first[c] = blocks.outer.data() + block.pairs[c];
    list.count[c] = block.pairs[c + 1] - block.pairs[c];
  }
  return list;
}

inline ListedPairs near_pairs(Blocks const& blocks, Block const& block, NearList near) {
  ListedPairs list;
  for (int c = 0; c < pair_classes; ++c) {
    list.first[c] = blocks.near[near].data() + block.pairs[c];
    list.count[c] = block.near[near][c];
  }
  return list;
}

/// Appends the pairs of a list of a block that touch on straight flights of `duration`, [tau_e], or
/// would if each disk deviated by up to `allowance`, or by the `usual`, [d_s]. records: of the
/// block, halo included.
inline void predict_contacts(Blocks const& blocks, Block const& block, ListedPairs const& list,
                             simd::Record const* records, Real duration, Real allowance, Real usual,
                             Forecast& forecast) {
  for (int c = 0; c < pair_classes; ++c) {
    Real const touch = class_distance(c);
    for (std::uint32_t k = 0; k < list.count[c]; k += simd::width) {
      auto const* pairs = list.first[c] + k;
      auto const d = simd::load_differences(records, pairs);
      auto const mask = may_meet(d, touch + 2 * allowance, duration);
      if (!mask.any()) continue;
      auto const meet = may_meet(d, touch, duration).lanes();
      auto const with_one = may_meet(d, touch + usual, duration).lanes();
      auto const with_two = may_meet(d, touch + 2 * usual, duration).lanes();
      for (auto lanes = mask.lanes(); lanes != 0; lanes &= lanes - 1) {
        int const n = __builtin_ctz(lanes);
        auto const pair = slot_pair(blocks, block, pairs[n]);
        if (!is_first_listing(pair)) continue;
        if (meet >> n & 1)
          forecast.meeting.push_back(pair);
        else
          forecast.near.push_back({pair, with_one >> n & 1 ? 1 : with_two >> n & 1 ? 2 : 3});
      }
    }
  }
}

}  // namespace bagnold
