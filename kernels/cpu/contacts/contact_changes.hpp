// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/blocks.hpp"
#include "kernels/cpu/contacts/contact_event.hpp"
#include "kernels/cpu/contacts/contact_sample.hpp"

namespace bagnold {

/// Calls pack(class, pairs, touched, touching, d) for each pack of pairs of a block's inner list.
/// touched: lanes in contact before, from `touched`; touching: lanes in contact now, by the
/// comparison that the forces use; d: r_ij and v_ij.
///
/// records: of the block, halo included; touched: a byte for each pack of the inner list.
template <class OfPack>
void for_contacts(Blocks const& blocks, Block const& block, simd::Record const* records,
                  std::uint8_t* touched, OfPack const& of_pack) {
  for (int c = 0; c < pair_classes; ++c) {
    simd::Pack const reach2 = class_distance(c) * class_distance(c);
    auto const begin = block.pairs[c];
    for (std::uint32_t k = 0; k < block.near[inner_list][c]; k += simd::width) {
      auto const* const pairs = blocks.near[inner_list].data() + begin + k;
      auto const d = simd::load_differences(records, pairs);
      auto const touching = (fma(d.x, d.x, d.y * d.y) < reach2).lanes();
      of_pack(c, pairs, touched[(begin + k) / simd::width], touching, d);
    }
  }
}

/// Calls changed(pair, begins, r_ij, v_ij) for pairs whose contact has begun or ended, and updates
/// `touched`.
template <class Changed>
void contact_changes(Blocks const& blocks, Block const& block, simd::Record const* records,
                     std::uint8_t* touched, Changed const& changed) {
  for_contacts(blocks, block, records, touched,
               [&](int, simd::LocalPair const* pairs, std::uint8_t& before, unsigned touching,
                   simd::Records const& d) {
                 for (auto lanes = touching ^ before; lanes != 0; lanes &= lanes - 1) {
                   int const n = __builtin_ctz(lanes);
                   changed(pairs[n], (touching >> n & 1) != 0, Vec2<Real>{d.x.v[n], d.y.v[n]},
                           Vec2<Real>{d.vx.v[n], d.vy.v[n]});
                 }
                 before = static_cast<std::uint8_t>(touching);
               });
}

/// Sums over pairs in contact, one after the other in the order of the list, as PackSums does: a
/// pair across the edge of a block counts half. spin(class, pair): see contact_velocities();
/// see(pair, r_ij, v_ij, spin) is called for each.
template <class Spin, class See>
ContactMotion contact_motion(Blocks const& blocks, Block const& block, simd::Record const* records,
                             std::uint8_t* touched, Spin const& spin, See const& see) {
  ContactMotion sums;
  for_contacts(blocks, block, records, touched,
               [&](int c, simd::LocalPair const* pairs, std::uint8_t const&, unsigned touching,
                   simd::Records const& d) {
                 for (auto lanes = touching; lanes != 0; lanes &= lanes - 1) {
                   int const n = __builtin_ctz(lanes);
                   bool const inside = std::max(pairs[n].a(), pairs[n].b()) < block.padded;
                   Vec2<Real> const separation{d.x.v[n], d.y.v[n]}, velocity{d.vx.v[n], d.vy.v[n]};
                   Real const common = spin(c, pairs[n]);
                   sums.add(inside ? 1 : 0.5, separation, velocity, common);
                   see(pairs[n], separation, velocity, common);
                 }
               });
  return sums;
}

/// Sets `touched` to is_open(pair).
template <class IsOpen>
void fill_touched(Blocks const& blocks, Block const& block, std::uint8_t* touched,
                  IsOpen const& is_open) {
  for (int c = 0; c < pair_classes; ++c)
    for (std::uint32_t k = 0; k < block.near[inner_list][c]; k += simd::width) {
      unsigned lanes = 0;
      auto const end = std::min<std::uint32_t>(simd::width, block.near[inner_list][c] - k);
      for (std::uint32_t n = 0; n < end; ++n) {
        bool const open = is_open(blocks.near[inner_list](block.pairs[c] + k + n));
        lanes |= static_cast<unsigned>(open) << n;
      }
      touched[(block.pairs[c] + k) / simd::width] = static_cast<std::uint8_t>(lanes);
    }
}

}  // namespace bagnold
