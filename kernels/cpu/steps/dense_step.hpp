// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/active_disks.hpp"
#include "kernels/cpu/steps/block_step.hpp"

namespace bagnold {

/// The same step as BlockStep, bit for bit, where few of the near pairs touch: contacts are looked for
/// first, forces worked out for them alone, and all disks that touch nothing are moved in one stream,
/// x += v dt.
template <ContactLaw Law, class Repulsion>
struct DenseStep {
  using Step = BlockStep<Law, Repulsion>;
  using Force = typename Step::Force;
  static constexpr bool rotates = Law::rotates;

  ActiveDisks active;

  /// Room for new blocks. loop: makes cleared room.
  template <class Loop>
  void resize(Loop& loop, Step& step) {
    active.resize(loop, step.blocks);
  }

  /// First half: trial state at t + dt from forces at t. force: scratch, [most_local].
  BlockReport predict(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force) const {
    using simd::Pack;
    Block const& block = step.blocks.block(b);
    refresh_halo(step.blocks, block, step.now, box);
    active.count(b) = 0;
    active.find(step.blocks, b, step.now.record.data() + block.first, force);
    step.add_forces(block, contact_list, step.now, force, NoPackObserver{});

    auto const* const now = step.now.record.data() + block.first;
    auto* const trial = step.trial.record.data() + block.first;
    simd::fly(trial, now, block.padded, step.time_step);
    if constexpr (rotates)
      std::copy_n(spins(step.now, block), block.padded, spins(step.trial, block));
    typename Step::Kick const kick(step.table, step.time_step);
    active.each_pack(block, active.count(b), step.species.data(), [&](std::uint16_t const* at, simd::Mask big) {
      auto r = simd::load_records(now, at);
      auto const f = simd::load_forces(force, at);
      Pack const k = kick.per_mass(big);
      r.x = fma(step.time_step, r.vx, r.x);
      r.y = fma(step.time_step, r.vy, r.y);
      r.vx = fma(k, f.x, r.vx);
      r.vy = fma(k, f.y, r.vy);
      simd::store_records(trial, at, r);
      if constexpr (rotates)
        simd::store(spins(step.trial, block), at,
                    fma(kick.per_inertia(big), f.turn, simd::load(spins(step.now, block), at)));
    });
    return {};
  }

  /// Second half: the state at t + dt from forces at the trial state, observed or not. moved: scratch,
  /// [most_local]. The report's speed is that of the disks that touch.
  BlockReport correct(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force, bool,
                      simd::Record* moved) const {
    using simd::Pack;
    Block const& block = step.blocks.block(b);
    refresh_halo(step.blocks, block, step.trial, box);
    active.find(step.blocks, b, step.trial.record.data() + block.first, force);
    OverlapWatch watch;
    step.add_forces(block, contact_list, step.trial, force, watch);

    auto* const now = step.now.record.data() + block.first;
    auto const* const trial = step.trial.record.data() + block.first;
    typename Step::Kick const kick(step.table, step.time_step / 2);
    Pack fastest2 = 0.0, poison = 0.0;
    auto* to = moved;
    active.each_pack(block, active.count(b), step.species.data(), [&](std::uint16_t const* at, simd::Mask big) {
      auto r = simd::load_records(now, at);
      auto const t = simd::load_records(trial, at);
      auto const f = simd::load_forces(force, at);
      Pack const k = kick.per_mass(big);
      Pack const vx = fma(k, f.x, 0.5 * (r.vx + t.vx));
      Pack const vy = fma(k, f.y, 0.5 * (r.vy + t.vy));
      r.x = fma(step.time_step / 2, r.vx + vx, r.x);
      r.y = fma(step.time_step / 2, r.vy + vy, r.y);
      r.vx = vx;
      r.vy = vy;
      simd::store_records(to, r);
      to += simd::width;
      if constexpr (rotates)
        simd::store(spins(step.now, block), at,
                    fma(kick.per_inertia(big), f.turn,
                        0.5 * (simd::load(spins(step.now, block), at) +
                               simd::load(spins(step.trial, block), at))));
      Pack const ux = fnma(box.strain_rate, r.y, vx);
      Pack const speed2 = fma(ux, ux, vy * vy);
      fastest2 = max(fastest2, speed2);
      poison = fma(speed2 + r.x, 0.0, poison);
    });
    simd::fly(now, now, block.padded, step.time_step);
    auto const* const at = active.list.data() + block.first;
    for (std::uint32_t k = 0; k < active.count(b); ++k) {
      simd::at(now, at[k]) = moved[k];
      active.is_active(block.first + at[k] / 4u) = 0;
    }
    return {simd::largest(fastest2), simd::largest(watch.largest), watch.touching, simd::sum(poison)};
  }

 private:
  static double* spins(BlockState const& state, Block const& block) {
    return state.spin.data() + block.first;
  }
};

}  // namespace bagnold
