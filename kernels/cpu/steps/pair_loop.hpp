// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// Constants of the pairs of one class, a the smaller disk of a pair.
struct PairClass {
  simd::Pack inverse_distance;  ///< 1/d_ij, [1/d_s]
  Real diameter;                ///< d_a, [d_s]
  Real ratio;                   ///< d_b/d_a, so that d_a x_a + d_b x_b = d_a (x_a + ratio x_b)

  explicit PairClass(int pair_class)
      : inverse_distance(1 / class_distance(pair_class)),
        diameter(first_diameter(pair_class)),
        ratio(second_diameter(pair_class) / first_diameter(pair_class)) {}
};

/// Goes through the pairs of one class in a near list of a block, a pack at a time. Each pack is
/// loaded before the previous one is worked on, so that loads and arithmetic overlap.
///
/// body.load(pairs): data of a pack; body(pairs, left, data): work on it, `left` pairs before the
/// end of the list. body is a copy: what it stores cannot alias its constants.
template <class Body>
BAGNOLD_INLINE void each_pack(Blocks const& blocks, Block const& block, NearList list,
                              int pair_class, Body body) {
  auto const* const pairs = blocks.near[list].data() + block.pairs[pair_class];
  auto const count = block.near[list][pair_class];
  if (count == 0) return;
  auto next = body.load(pairs);
  for (std::uint32_t k = 0; k < count; k += simd::width) {
    auto const now = next;
    next = body.load(pairs + (k + simd::width < count ? k + simd::width : 0));
    body(pairs + k, count - k, now);
  }
}

}  // namespace bagnold
