// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"
#include "kernels/physics/schemes/scheme.hpp"
#include "kernels/physics/schemes/second_look.hpp"

namespace bagnold {

/// The papers' step on a block (P2 Eqs. 21-24), as in modified_velocity_verlet.hpp.
template <ContactLaw Law, class Repulsion>
struct BlockStep : BlockSystem<Law, Repulsion, false> {
  using System = BlockSystem<Law, Repulsion, false>;
  using typename System::Force;
  using typename System::Kick;
  using System::blocks, System::now, System::trial, System::species, System::table,
      System::time_step, System::rotates;
  static constexpr Scheme scheme = Scheme::modified_velocity_verlet;
  static constexpr bool lists_contacts = false;
  static constexpr StepCosts costs{.by_itself = 7, .contact = 39, .dense_below = 0.3};

  SecondLook const* second_look() const { return nullptr; }

  /// First half: trial state at t + dt from forces at t. force: scratch, [most_local].
  BlockReport predict(std::uint32_t b, ShearedBox const& box, Force* force) const {
    using simd::Pack;
    Block const& block = blocks.block(b);
    refresh_halo(blocks, block, now, box);
    auto const* record = now.record.data() + block.first;
    this->evaluate(block, now, force, NoPackObserver{});
    Kick const kick(table, time_step);
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto r = simd::load_records(record + i);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(species.data() + block.first + i);
      Pack const k = kick.per_mass(big);
      r.x = fma(time_step, r.vx, r.x);
      r.y = fma(time_step, r.vy, r.y);
      r.vx = fma(k, f.x, r.vx);
      r.vy = fma(k, f.y, r.vy);
      simd::store_records(trial.record.data() + block.first + i, r);
      if constexpr (rotates)
        fma(kick.per_inertia(big), f.turn, Pack::load(now.spin.data() + block.first + i))
            .store(trial.spin.data() + block.first + i);
    }
    return {};
  }

  /// Second half: the state at t + dt from forces at the trial state, observed or not. seen(slot,
  /// records): called with the new motion of each pack of disks.
  template <class Watch>
  BlockReport correct(std::uint32_t b, ShearedBox const& box, Force* force, bool,
                      Watch&& seen) const {
    using simd::Pack;
    Block const& block = blocks.block(b);
    refresh_halo(blocks, block, trial, box);
    OverlapWatch watch;
    this->evaluate(block, trial, force, watch);
    Kick const kick(table, time_step / 2);
    Pack fastest2 = 0.0, poison = 0.0;
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(now.record.data() + slot);
      auto const t = simd::load_records(trial.record.data() + slot);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(species.data() + slot);
      Pack const k = kick.per_mass(big);
      Pack const vx = fma(k, f.x, 0.5 * (r.vx + t.vx));
      Pack const vy = fma(k, f.y, 0.5 * (r.vy + t.vy));
      r.x = fma(time_step / 2, r.vx + vx, r.x);
      r.y = fma(time_step / 2, r.vy + vy, r.y);
      r.vx = vx;
      r.vy = vy;
      simd::store_records(now.record.data() + slot, r);
      seen(slot, r);
      if constexpr (rotates)
        fma(kick.per_inertia(big), f.turn, 0.5 * (Pack::load(now.spin.data() + slot) + Pack::load(trial.spin.data() + slot)))
            .store(now.spin.data() + slot);
      Pack const ux = fnma(box.strain_rate, r.y, vx);
      Pack const speed2 = fma(ux, ux, vy * vy);
      fastest2 = max(fastest2, speed2);
      poison = fma(speed2 + r.x, 0.0, poison);
    }
    return {simd::largest(fastest2), simd::largest(watch.largest), watch.touching, simd::sum(poison)};
  }

  static constexpr int observed_forces = 1;

  /// Sees all pairs of the inner list as they are between the two halves of a step. force:
  /// [most_local], out: all forces.
  template <class Observer>
  void observe(Block const& block, Force* force, Observer&& observer) const {
    this->evaluate(block, now, force, observer);
  }

  /// Of eight disks from i on, after observe(). spin: theirs.
  PackPower observed_power(Force const* force, std::uint32_t i, simd::Mask big,
                           simd::Pack spin) const {
    PackPower power;
    if constexpr (rotates)
      power.torque = System::diameter_of(big) * simd::load_forces(force + i).turn * spin;
    return power;
  }
};

}  // namespace bagnold
