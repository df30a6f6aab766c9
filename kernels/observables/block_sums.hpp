// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/dynamics/block_step.hpp"
#include "kernels/observables/sums.hpp"

namespace bagnold {

/// Adds up pairs a pack at a time. A pair across the edge of a block is seen by both of its blocks
/// and counts half in each.
struct PackSums {
  std::uint32_t padded;                   ///< of the block: partners from here on are halo
  simd::Pack value[SumColumns::count]{};  ///< the pair columns are used

  void operator()(PackOfPairs const& p) {
    using simd::Pack;
    Pack weight;
    for (int k = 0; k < simd::width; ++k) weight.v[k] = p.pairs[k].b() < padded ? 1.0 : 0.5;
    weight = zero_unless(p.touching, weight);
    auto const add = [&](int column, Pack f, Pack r) {
      value[column] += zero_unless(p.touching, weight * f * r);
    };
    auto const& [r, elastic, dissipative, overlap] = p.force;
    add(SumColumns::elastic_xx, elastic.x, r.x);
    add(SumColumns::elastic_xy, elastic.x, r.y);
    add(SumColumns::elastic_yy, elastic.y, r.y);
    add(SumColumns::dissipative_xx, dissipative.x, r.x);
    add(SumColumns::dissipative_xy, dissipative.x, r.y);
    add(SumColumns::dissipative_yx, dissipative.y, r.x);
    add(SumColumns::dissipative_yy, dissipative.y, r.y);
    value[SumColumns::contacts] += weight + weight;
  }
};

/// The sums of one block: its pairs, and its own disks (inert ones add zero).
template <ContactLaw Law, class Repulsion>
Sums<Law::rotates> measure_block(BlockStep<Law, Repulsion> const& step, std::uint32_t b,
                                 ShearedBox const& box,
                                 typename BlockStep<Law, Repulsion>::Force* force) {
  using simd::Pack;
  using C = SumColumns;
  Block const& block = step.blocks.block(b);
  refresh_halo(step.blocks, block, step.now, box);
  PackSums packs{block.padded};
  step.evaluate(block, step.now, force, packs);
  Pack spin = 0.0, spin2 = 0.0;
  auto* const v = packs.value;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const slot = block.first + i;
    auto const r = simd::load_records(step.now.record.data() + slot);
    auto const big = simd::nonzero(step.species.data() + slot);
    Pack const mass = select(big, 1 / step.table.inverse_mass[1], 1 / step.table.inverse_mass[0]);
    Pack const ux = fnma(box.strain_rate, r.y, r.vx), uy = r.vy;
    v[C::kinetic_xx] += mass * ux * ux;
    v[C::kinetic_xy] += mass * ux * uy;
    v[C::kinetic_yy] += mass * uy * uy;
    v[C::velocity_x2] += ux * ux;
    v[C::velocity_y2] += uy * uy;
    if constexpr (Law::rotates) {
      Pack const inverse_diameter = select(big, 1 / big_diameter, 1 / small_diameter);
      Pack const s = inverse_diameter * Pack::load(step.now.spin.data() + slot);
      spin += s;
      spin2 += s * s;
    }
  }
  Sums<Law::rotates> sums;
  for (int c = 0; c < C::count; ++c) sums.value[c] = simd::sum(v[c]);
  if constexpr (Law::rotates) {
    sums.value[C::spin] = simd::sum(spin);
    sums.value[C::spin2] = simd::sum(spin2);
  }
  return sums;
}

}  // namespace bagnold
