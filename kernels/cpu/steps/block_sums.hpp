// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Adds up pairs one after the other, in the order of the list, so that the sums do not depend on
/// when it was pruned. A pair across the edge of a block is in the lists of both blocks and counts
/// half in each.
struct PackSums {
  static constexpr int whole = pair_columns / simd::width;  ///< packs of columns
  static constexpr int rest = pair_columns % simd::width;   ///< columns left over

  std::uint32_t padded;          ///< of the block: partners from here on are halo
  simd::Pack first[whole] = {};  ///< columns of PairColumns
  Real last[rest + 1] = {};      ///< and those left over; one more, as none is no array
  Real contacts = 0;

  void operator()(PackOfPairs const& p) {
    auto of = columns_of(p.force);
    for (int w = 0; w < whole; ++w) simd::transpose(of.value + w * simd::width);
    for (unsigned lanes = p.touching.lanes(); lanes != 0; lanes &= lanes - 1) {
      int const k = __builtin_ctz(lanes);
      Real const weight = std::max(p.pairs[k].a(), p.pairs[k].b()) < padded ? 1.0 : 0.5;
      for (int w = 0; w < whole; ++w) first[w] += weight * of.value[w * simd::width + k];
      for (int c = 0; c < rest; ++c) last[c] += weight * of.value[whole * simd::width + c].v[k];
      contacts += 2 * weight;
    }
  }

  Real column(int c) const {
    int const w = c / simd::width;
    return w < whole ? first[w].v[c % simd::width] : last[c % simd::width];
  }
};

/// Sums of a block over its pairs, before the last pass of a step. force: scratch, as
/// Step::observe() needs it.
template <class Step>
BlockReport sum_pairs(Step const& step, BlockSystem const& s, std::uint32_t b, StepAt const& at,
                      typename Step::Force* force) {
  Block const& block = s.blocks.block(b);
  PackSums pairs{block.padded};
  step.observe(s, block, force, pairs);
  BlockSums& sums = at.sums[b] = {};
  for (int c = 0; c < pair_columns; ++c) sums.value[c] = pairs.column(c);
  sums.value[SumColumns::contacts] = pairs.contacts;
  return {};
}

/// Adds sums over the own disks of a block (inert ones add zero), with the scratch as sum_pairs()
/// left it.
template <class Step>
BlockReport sum_disks(Step const& step, BlockSystem const& s, std::uint32_t b, StepAt const& at,
                      typename Step::Force* force) {
  using simd::Pack;
  using C = SumColumns;
  Block const& block = s.blocks.block(b);
  Real const strain_rate = at.box.strain_rate;
  Pack of_disks[C::count_rotating];
  for (auto& sum : of_disks) sum = 0.0;
  PackPower power;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const slot = block.first + i;
    auto const r = simd::load_records(s.now.record.data() + slot);
    auto const big = simd::nonzero(s.species.data() + slot);
    Pack const mass = select(big, 1 / s.table.inverse_mass[1], 1 / s.table.inverse_mass[0]);
    add_motion(of_disks, mass, peculiar_x(r.vx, r.y, strain_rate), r.vy);
    Pack spin = 0.0;
    if constexpr (Step::rotates) {
      spin = Pack::load(s.now.spin.data() + slot);
      add_spin(of_disks, spin);
    }
    auto const of_pack = step.observed_power(s, block, force, i, big, r, spin, strain_rate);
    power.dissipation += of_pack.dissipation;
    power.torque += of_pack.torque;
  }
  BlockSums& sums = at.sums[b];
  for (int c = pair_columns; c < C::count_rotating; ++c)
    if (c != C::contacts) sums.value[c] = simd::sum(of_disks[c]);
  sums.value[C::dissipation] += simd::sum(power.dissipation);
  sums.value[C::torque_power] = simd::sum(power.torque);
  return {};
}

}  // namespace bagnold
