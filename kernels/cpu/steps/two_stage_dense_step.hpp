// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/active_disks.hpp"
#include "kernels/cpu/steps/two_stage_block_step.hpp"

namespace bagnold {

/// The same step as TwoStageBlockStep, bit for bit, where few of the near pairs touch, as DenseStep does
/// for the papers' scheme. `trial` is zero wherever nothing changes.
template <ContactLaw Law, class Repulsion>
struct TwoStageDenseStep {
  using Step = TwoStageBlockStep<Law, Repulsion>;
  using Force = typename Step::Force;
  static constexpr bool rotates = Law::rotates;

  ActiveDisks active;

  /// Room for new blocks, of which nothing has changed yet. loop: makes cleared room.
  template <class Loop>
  void resize(Loop& loop, Step& step) {
    active.resize(loop, step.blocks);
    loop(step.blocks.count, [&](std::uint32_t b) {
      Block const& block = step.blocks.block(b);
      active.count(b) = 0;
      std::fill_n(step.trial.record.data() + block.first, block.padded, simd::Record{});
    });
  }

  /// First half: what the forces at t change. force: scratch, [most_local].
  BlockReport predict(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force) const {
    Block const& block = step.blocks.block(b);
    auto* const change = step.trial.record.data() + block.first;
    refresh_halo(step.blocks, block, step.now, box);
    auto const* const before = active.list.data() + block.first;
    for (std::uint32_t k = 0; k < active.count(b); ++k) simd::at(change, before[k]) = {};
    active.count(b) = 0;
    active.find(step.blocks, b, step.now.record.data() + block.first, force);
    OverlapWatch watch;
    step.add_forces(block, contact_list, step.now, force, watch);
    typename Step::Kick const kick(step.table, step.time_step);
    active.each_pack(block, active.count(b), step.species.data(), [&](std::uint16_t const* at, simd::Mask big) {
      simd::store_records(change, at, Step::change_of(kick, simd::load_forces(force, at), big));
    });
    return {0, simd::largest(watch.largest), watch.touching, 0};
  }

  /// Second half: the damping of the changes, and the state at t + dt. observed: force is as
  /// Step::observe() left it. The report's speed is that of the disks that touch.
  BlockReport correct(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force,
                      bool observed, simd::Record*) const {
    using simd::Pack;
    Block const& block = step.blocks.block(b);
    auto* const now = step.now.record.data() + block.first;
    auto* const change = step.trial.record.data() + block.first;
    if (observed) {
      force += step.blocks.most_local;
    } else {
      clear_touching(step, block, force);
      step.add_second(block, force);
    }
    typename Step::Kick const kick(step.table, step.time_step);
    Pack fastest2 = 0.0, poison = 0.0;
    auto const* const list = active.list.data() + block.first;
    for (auto k = active.count(b); k < simd::round_up(active.count(b)); ++k)
      simd::at(force, list[k]) = Force{};
    active.each_pack(block, active.count(b), step.species.data(), [&](std::uint16_t const* at, simd::Mask big) {
      auto r = simd::load_records(now, at);
      auto const of_first = simd::load_records(change, at);
      auto const f = simd::load_forces(force, at);
      Step::accelerate(r, of_first, f, kick.per_mass(big));
      simd::store_records(now, at, r);
      if constexpr (rotates) {
        auto* const spin = step.now.spin.data() + block.first;
        simd::store(spin, at, Step::spun(simd::load(spin, at), of_first, f, kick.per_inertia(big)));
      }
      Pack const ux = fnma(box.strain_rate, fma(step.time_step, r.vy, r.y), r.vx);
      Pack const speed2 = fma(ux, ux, r.vy * r.vy);
      fastest2 = max(fastest2, speed2);
      poison = fma(speed2 + r.x, 0.0, poison);
    });
    simd::fly(now, now, block.padded, step.time_step);
    for (std::uint32_t k = 0; k < active.count(b); ++k)
      active.is_active(block.first + list[k] / 4u) = 0;
    return {simd::largest(fastest2), 0, 0, simd::sum(poison)};
  }

 private:
  static void clear_touching(Step const& step, Block const& block, Force* force) {
    for (int c = 0; c < pair_classes; ++c) {
      auto const* pairs = step.blocks.near[contact_list].data() + block.pairs[c];
      for (std::uint32_t k = 0; k < simd::round_up(block.near[contact_list][c]); ++k)
        simd::at(force, pairs[k].a4) = simd::at(force, pairs[k].b4) = Force{};
    }
  }
};

}  // namespace bagnold
