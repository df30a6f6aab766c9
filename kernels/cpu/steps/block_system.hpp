// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// Positions and velocities of all blocks, by slot.
struct BlockState {
  Blocks::Array<simd::Record> record;
  Blocks::Array<double> spin;  ///< thetadot, [1 / tau_e]; empty if the law does not rotate
};

/// Record of the image of a disk.
inline simd::Record at_image(simd::Record record, Image const& image, ShearedBox const& box) {
  Vec2<Real> const shift = box.shift(image);
  record.x += shift.x;
  record.y += shift.y;
  record.vx += box.velocity_shift(image);
  return record;
}

/// Reads numbers sequentially, so that the processor's prefetcher loads them. The order of pairs,
/// in which they are used next, is one that the prefetcher cannot follow.
template <class T>
void bring_near(T const* first, std::uint32_t count) {
  constexpr std::uint32_t line = 64 / sizeof(T);
  for (std::uint32_t i = 0; i < count; i += line)
    static_cast<void>(*reinterpret_cast<char const volatile*>(first + i));
}

/// Reads a state of a block's disks sequentially if it is not in cache.
inline void bring_near(Blocks const& blocks, Block const& block, BlockState const& state) {
  if (!blocks.beyond_cache()) return;
  bring_near(state.record.data() + block.first, block.padded);
  if (state.spin.extent(0) != 0) bring_near(state.spin.data() + block.first, block.padded);
}

/// Prefetches the disks that a halo copies, so that their loads overlap.
inline void bring_halo_near(Blocks const& blocks, Block const& block, BlockState const& state) {
  if (!blocks.beyond_cache()) return;
  auto const* const halo = blocks.halo.data() + block.halo_first;
  for (std::uint32_t h = 0; h < block.halo; ++h) {
    __builtin_prefetch(state.record.data() + halo[h].index());
    if (state.spin.extent(0) != 0) __builtin_prefetch(state.spin.data() + halo[h].index());
  }
}

/// Copies the disks of other blocks, and images, into a block's halo.
inline void refresh_halo(Blocks const& blocks, Block const& block, BlockState const& state,
                         ShearedBox const& box) {
  auto const* halo = blocks.halo.data() + block.halo_first;
  auto* const record = state.record.data();
  auto const to = block.first + block.padded;
  bring_halo_near(blocks, block, state);
  bring_near(blocks, block, state);
  for (std::uint32_t h = 0; h < block.halo; ++h) {
    record[to + h] = at_image(record[halo[h].index()], halo[h].image(), box);
    if (state.spin.extent(0) != 0) state.spin(to + h) = state.spin(halo[h].index());
  }
}

/// Largest (v - gammadot y x^)^2 of a block's disks, [d_s^2 / tau_e^2].
inline Real fastest2_of(Block const& block, BlockState const& state, Real strain_rate) {
  simd::Pack fastest2 = 0.0;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const r = simd::load_records(state.record.data() + block.first + i);
    simd::Pack const ux = fnma(strain_rate, r.y, r.vx);
    fastest2 = max(fastest2, fma(ux, ux, r.vy * r.vy));
  }
  return simd::largest(fastest2);
}

/// Scales the motion of a block's disks with the strain rate, P2 Eqs. (40)-(41).
inline void scale_motion(Block const& block, BlockState const& state, Real factor) {
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto* const record = state.record.data() + block.first + i;
    auto r = simd::load_records(record);
    r.vx = factor * r.vx;
    r.vy = factor * r.vy;
    simd::store_records(record, r);
  }
  if (state.spin.extent(0) == 0) return;
  auto* const spin = state.spin.data() + block.first;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width)
    (simd::Pack(factor) * simd::Pack::load(spin + i)).store(spin + i);
}

/// Adds to the motion of a block's disks what the mean flow gains where the strain rate changes:
/// the excess over it stays.
inline void follow_flow(Block const& block, BlockState const& state, Real rise) {
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto* const record = state.record.data() + block.first + i;
    auto r = simd::load_records(record);
    r.vx = fma(simd::Pack(rise), r.y, r.vx);
    simd::store_records(record, r);
  }
  if (state.spin.extent(0) == 0) return;
  auto* const spin = state.spin.data() + block.first;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width)
    (simd::Pack::load(spin + i) - simd::Pack(rise / 2)).store(spin + i);
}

/// Report of a step on a block; each half of the step adds its part.
struct BlockReport {
  Real fastest2 = 0;           ///< largest (v - gammadot y x^)^2, [d_s^2 / tau_e^2]
  Real largest_overlap = 0;    ///< relative
  std::uint32_t touching = 0;  ///< pairs, those across the edge included
  Real nan_flag = 0;           ///< 0, or NaN where a motion is
  Real coupling = 0;           ///< of an ImplicitScheme: bounds the eigenvalues of theta dt A

  BlockReport& operator+=(BlockReport const& o) {
    fastest2 = std::max(fastest2, o.fastest2);
    largest_overlap = std::max(largest_overlap, o.largest_overlap);
    touching += o.touching;
    nan_flag += o.nan_flag;
    coupling = std::max(coupling, o.coupling);
    return *this;
  }
};

/// Disks in blocks, and their state.
struct BlockSystem {
  Blocks blocks;
  Blocks::Array<Species> species;  ///< by slot
  SpeciesTable table;
  BlockState now;
  BlockState trial;  ///< what the first pass of a step leaves to the later ones
  Blocks::Array<simd::Record> more_records[2];  ///< by slot, of a scheme that needs them
  Blocks::Array<double> of_pairs;               ///< numbers of each pair, in packs, likewise
  bool rotates = false;                         ///< spins are there
  std::int64_t arrangement = 0;                 ///< counts rearrangements of disks in slots
  std::int64_t listing = 0;                     ///< counts prunings of the inner lists
  std::int64_t step = 0;                        ///< steps done
  Blocks::Array<std::uint32_t> disk_of;  ///< by slot, the index at the start; if a drive needs it

  /// (d_i thetadot_i + d_j thetadot_j) / (d_i + d_j) of two slots, [1/tau_e]; 0 without spins.
  Real common_spin(std::uint32_t i, std::uint32_t j) const {
    if (!rotates) return 0;
    Real const a = table.diameter[species(i)], b = table.diameter[species(j)];
    return (a * now.spin(i) + b * now.spin(j)) / (a + b);
  }

  /// (d_i thetadot_i + d_j thetadot_j) / (d_i + d_j) of a pair of a class, halo included,
  /// [1/tau_e].
  Real common_spin(Block const& block, int pair_class, simd::LocalPair const& pair) const {
    if (!rotates) return 0;
    Real const a = first_diameter(pair_class), b = second_diameter(pair_class);
    return (a * now.spin(block.first + pair.a()) + b * now.spin(block.first + pair.b())) / (a + b);
  }
};

}  // namespace bagnold
