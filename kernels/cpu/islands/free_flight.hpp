// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/flight_sums.hpp"
#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Largest |w|^2 of a block's disks after straight flight for `duration`. w is linear in time, so
/// it is largest at one end of the flight. strain: since the build, at the end of the flight.
inline Real farthest2_after(Block const& block, simd::Record const* records,
                            Vec2<Real> const* at_build, Real duration, Real strain) {
  using simd::Pack;
  Pack largest = 0.0;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const r = simd::load_records(records + i);
    auto const built = simd::load_pairs(&at_build[i].x);
    Pack const wx = fnma(strain, built.y, fma(duration, r.vx, r.x) - built.x);
    Pack const wy = fma(duration, r.vy, r.y) - built.y;
    largest = max(largest, fma(wx, wx, wy * wy));
  }
  return simd::largest(largest);
}

/// Moves all own disks of a block on straight lines.
inline void fly(Block const& block, simd::Record* records, Real duration) {
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto r = simd::load_records(records + i);
    r.x = fma(duration, r.vx, r.x);
    r.y = fma(duration, r.vy, r.y);
    simd::store_records(records + i, r);
  }
}

/// Time for which a block's disks can fly straight before a pair of its inner list touches,
/// [tau_e]; at most `most`.
inline Real free_time(Blocks const& blocks, Block const& block, simd::Record const* records,
                      Real most) {
  using simd::Pack;
  Pack first = most;
  for (int c = 0; c < pair_classes; ++c) {
    Real const touch = class_distance(c);
    auto const* pairs = blocks.near[inner_list].data() + block.pairs[c];
    for (std::uint32_t k = 0; k < block.near[inner_list][c]; k += simd::width) {
      auto const d = simd::load_differences(records, pairs + k);
      Pack const b = fma(d.x, d.vx, d.y * d.vy), v2 = fma(d.vx, d.vx, d.vy * d.vy);
      Pack const r2 = fma(d.x, d.x, fma(d.y, d.y, -(touch * touch)));
      Pack const root2 = fma(b, b, -(v2 * r2));
      auto const inside = r2 < Pack(0.0);
      auto const meets = (b < Pack(0.0)) & (Pack(0.0) < root2);
      Pack const time = (-b - sqrt(positive_part(root2))) / v2;
      first = select(inside, 0.0, select(meets & (time < first), time, first));
    }
  }
  return -simd::largest(-first);
}

/// Sums of the own disks of a block for which free(slot) holds, a pack at a time. Inert disks add
/// zero.
template <class Free>
FlightSums flight_sums(BlockSystem const& system, Block const& block, Real strain_rate,
                       Free const& free) {
  using simd::Pack;
  Quadratic<Pack> packs[SumColumns::count_rotating];
  for (auto& column : packs) column = {{0.0, 0.0, 0.0}};
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const slot = block.first + i;
    auto const here = free(slot);
    auto const r = simd::load_records(system.now.record.data() + slot);
    auto const big = simd::nonzero(system.species.data() + slot);
    Pack const mass =
        select(big, 1 / system.table.inverse_mass[1], 1 / system.table.inverse_mass[0]);
    Pack const vy = zero_unless(here, r.vy);
    auto ux = flight_x(r.vx, r.y, vy, strain_rate);
    ux.c[0] = zero_unless(here, ux.c[0]);
    add_motion(packs, mass, ux, vy);
    if (system.rotates)
      add_spin(packs, zero_unless(here, Pack::load(system.now.spin.data() + slot)));
  }
  FlightSums sums;
  for (int c = pair_columns; c < SumColumns::count_rotating; ++c)
    for (int k = 0; k < 3; ++k) sums.column[c].c[k] = simd::sum(packs[c].c[k]);
  return sums;
}

}  // namespace bagnold
