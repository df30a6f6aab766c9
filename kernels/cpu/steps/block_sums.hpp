// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Adds up pairs one after the other, in the order of the list, so that the sums do not depend on when
/// it was pruned. A pair across the edge of a block is seen by both of its blocks and counts half in
/// each.
struct PackSums {
  using C = SumColumns;
  static_assert(C::dissipation == simd::width - 1);

  std::uint32_t padded;    ///< of the block: partners from here on are halo
  simd::Pack first = 0.0;  ///< columns up to C::dissipation
  Real contacts = 0;

  void operator()(PackOfPairs const& p) {
    auto const& [r, elastic, dissipative, overlap, velocity] = p.force;
    simd::Pack of[simd::width];
    of[C::elastic_xx] = elastic.x * r.x;
    of[C::elastic_xy] = elastic.x * r.y;
    of[C::elastic_yy] = elastic.y * r.y;
    of[C::dissipative_xx] = dissipative.x * r.x;
    of[C::dissipative_xy] = dissipative.x * r.y;
    of[C::dissipative_yx] = dissipative.y * r.x;
    of[C::dissipative_yy] = dissipative.y * r.y;
    of[C::dissipation] = p.force.dissipation();
    simd::transpose(of);
    for (unsigned lanes = p.touching.lanes(); lanes != 0; lanes &= lanes - 1) {
      int const k = __builtin_ctz(lanes);
      Real const weight = std::max(p.pairs[k].a(), p.pairs[k].b()) < padded ? 1.0 : 0.5;
      first += weight * of[k];
      contacts += 2 * weight;
    }
  }
};

/// The sums of one block: its pairs, and its own disks (inert ones add zero). When the block and its
/// neighbours have been through the first half of a step, and it has not been through the second.
/// force: scratch, [Step::observed_forces][most_local].
template <class Step>
BlockSums measure_block(Step const& step, BlockSystem const& s, std::uint32_t b, Real strain_rate,
                        typename Step::Force* force) {
  using simd::Pack;
  using C = SumColumns;
  Block const& block = s.blocks.block(b);
  PackSums pairs{block.padded};
  step.observe(s, block, force, pairs);
  Pack v[C::count], spin = 0.0, spin2 = 0.0;
  PackPower power;
  for (auto& sum : v) sum = 0.0;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const slot = block.first + i;
    auto const r = simd::load_records(s.now.record.data() + slot);
    auto const big = simd::nonzero(s.species.data() + slot);
    Pack const mass = select(big, 1 / s.table.inverse_mass[1], 1 / s.table.inverse_mass[0]);
    Pack const ux = fnma(strain_rate, r.y, r.vx), uy = r.vy;
    v[C::kinetic_xx] += mass * ux * ux;
    v[C::kinetic_xy] += mass * ux * uy;
    v[C::kinetic_yy] += mass * uy * uy;
    v[C::velocity_x2] += ux * ux;
    v[C::velocity_y2] += uy * uy;
    Pack turning = 0.0;
    if constexpr (Step::rotates) {
      turning = Pack::load(s.now.spin.data() + slot);
      spin += turning;
      spin2 += turning * turning;
    }
    auto const of_disks = step.observed_power(s, force, i, big, turning);
    power.dissipation += of_disks.dissipation;
    power.torque += of_disks.torque;
  }
  BlockSums sums;
  for (int c : {C::kinetic_xx, C::kinetic_xy, C::kinetic_yy, C::velocity_x2, C::velocity_y2})
    sums.value[c] = simd::sum(v[c]);
  for (int c = C::elastic_xx; c <= C::dissipation; ++c) sums.value[c] = pairs.first.v[c];
  sums.value[C::dissipation] += simd::sum(power.dissipation);
  sums.value[C::contacts] = pairs.contacts;
  if constexpr (Step::rotates) {
    sums.value[C::spin] = simd::sum(spin);
    sums.value[C::spin2] = simd::sum(spin2);
    sums.value[C::torque_power] = simd::sum(power.torque);
  }
  return sums;
}

}  // namespace bagnold
