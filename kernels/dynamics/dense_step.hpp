// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/blocks/prune.hpp"
#include "kernels/dynamics/block_step.hpp"

namespace bagnold {

/// The same step as BlockStep, bit for bit, where few of the near pairs touch: contacts are looked for
/// first, forces worked out for them alone, and all disks that touch nothing are moved in one stream,
/// x += v dt.
template <ContactLaw Law, class Repulsion>
struct DenseStep {
  using Step = BlockStep<Law, Repulsion>;
  using Force = typename Step::Force;
  static constexpr bool rotates = Law::rotates;

  Blocks::Array<std::uint16_t> active;      ///< [slots], by block: four times the index of each disk
                                            ///< that touches
  Blocks::Array<std::uint8_t> is_active;    ///< [slots]
  Blocks::Array<std::uint32_t> count;       ///< [blocks], in `active`

  /// Room for new blocks. loop: makes cleared room.
  template <class Loop>
  void resize(Loop& loop, Blocks& blocks) {
    auto& contacts = blocks.near[contact_list];
    if (contacts.extent(0) < blocks.outer.extent(0))
      contacts = Blocks::Array<simd::LocalPair>(
          Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string("dynamics::contacts")),
          blocks.outer.extent(0));
    if (active.extent(0) < blocks.slots) {
      active = {};
      is_active = {};
      active = loop.template zeros<std::uint16_t>("dynamics::active", blocks.slots);
      is_active = loop.template zeros<std::uint8_t>("dynamics::is_active", blocks.slots);
    }
    if (count.extent(0) < blocks.count)
      count = loop.template zeros<std::uint32_t>("dynamics::active_count", blocks.count);
  }

  /// First half: trial state at t + dt from forces at t. force: scratch, [most_local].
  void predict(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force) const {
    using simd::Pack;
    Block& block = step.blocks.block(b);
    refresh_halo(step.blocks, block, step.now, box);
    count(b) = 0;
    find(step, b, step.now, force);
    step.add_forces(block, contact_list, step.now, force, NoPackObserver{});

    auto const* const now = step.now.record.data() + block.first;
    auto* const trial = step.trial.record.data() + block.first;
    simd::fly(trial, now, block.padded, step.time_step);
    if constexpr (rotates)
      std::copy_n(spins(step.now, block), block.padded, spins(step.trial, block));
    typename Step::Kick const kick(step.table, step.time_step);
    each_active(step, block, count(b), [&](std::uint16_t const* at, simd::Mask big) {
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
  }

  /// Second half: the state at t + dt from forces at the trial state. moved: scratch, [most_local].
  /// The report's speed is that of the disks that touch.
  BlockReport correct(Step const& step, std::uint32_t b, ShearedBox const& box, Force* force,
                      simd::Record* moved) const {
    using simd::Pack;
    Block& block = step.blocks.block(b);
    refresh_halo(step.blocks, block, step.trial, box);
    find(step, b, step.trial, force);
    OverlapWatch watch;
    step.add_forces(block, contact_list, step.trial, force, watch);

    auto* const now = step.now.record.data() + block.first;
    auto const* const trial = step.trial.record.data() + block.first;
    typename Step::Kick const kick(step.table, step.time_step / 2);
    Pack fastest2 = 0.0, poison = 0.0;
    auto* to = moved;
    each_active(step, block, count(b), [&](std::uint16_t const* at, simd::Mask big) {
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
    auto const* const at = active.data() + block.first;
    for (std::uint32_t k = 0; k < count(b); ++k) {
      simd::at(now, at[k]) = moved[k];
      is_active(block.first + at[k] / 4u) = 0;
    }
    return {simd::largest(fastest2), simd::largest(watch.largest), watch.touching, simd::sum(poison)};
  }

 private:
  static double* spins(BlockState const& state, Block const& block) {
    return state.spin.data() + block.first;
  }

  /// Lists the pairs that touch, adds their disks to the active ones and clears the forces on these.
  void find(Step const& step, std::uint32_t b, BlockState const& state, Force* force) const {
    Block& block = step.blocks.block(b);
    prune_block(step.blocks, block, contact_list, state.record.data() + block.first, 0);
    auto* const list = active.data() + block.first;
    auto* const marked = is_active.data() + block.first;
    auto n = count(b);
    auto const add = [&](std::uint16_t at) {
      auto const i = at / 4u;
      force[i] = Force{};
      list[n] = at;
      bool const fresh = i < block.own && marked[i] == 0;
      n += fresh;
      if (fresh) marked[i] = 1;
    };
    for (std::uint32_t k = 0; k < count(b); ++k) simd::at(force, list[k]) = Force{};
    for (int c = 0; c < pair_classes; ++c) {
      auto const* pairs = step.blocks.near[contact_list].data() + block.pairs[c];
      for (std::uint32_t k = 0; k < block.near[contact_list][c]; ++k) {
        add(pairs[k].a4);
        add(pairs[k].b4);
      }
    }
    count(b) = n;
    auto const inert = static_cast<std::uint16_t>(4 * block.own);
    force[block.own] = force[block.own + 1] = Force{};
    for (auto k = n; k < simd::round_up(n); ++k) list[k] = inert;
  }

  /// body(at, big) for eight active disks at a time, the last ones inert.
  template <class Body>
  void each_active(Step const& step, Block const& block, std::uint32_t n, Body const& body) const {
    auto const* const list = active.data() + block.first;
    for (std::uint32_t k = 0; k < n; k += simd::width) {
      unsigned big = 0;
      for (int j = 0; j < simd::width; ++j)
        big |= static_cast<unsigned>(step.species(block.first + list[k + j] / 4u)) << j;
      body(list + k, simd::Mask::of(big));
    }
  }
};

}  // namespace bagnold
