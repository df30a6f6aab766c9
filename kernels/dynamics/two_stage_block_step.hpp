// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/dynamics/block_system.hpp"
#include "kernels/dynamics/scheme.hpp"
#include "kernels/dynamics/second_look.hpp"

namespace bagnold {

/// TwoStageLeapfrog (two_stage_leapfrog.hpp) on a block. `trial` holds what the first look changes: as
/// a record {v_x, v_y, thetadot, contacts} a disk.
template <ContactLaw Law, class Repulsion>
struct TwoStageBlockStep : BlockSystem<Law, Repulsion, true> {
  using System = BlockSystem<Law, Repulsion, true>;
  using typename System::Force;
  using typename System::Kick;
  using System::blocks, System::now, System::trial, System::species, System::table,
      System::time_step, System::rotates, System::forces;
  static constexpr Scheme scheme = Scheme::two_stage_leapfrog;

  /// First half: what the forces at t change. force: scratch, [most_local].
  BlockReport predict(std::uint32_t b, ShearedBox const& box, Force* force) const {
    using simd::Pack;
    Block const& block = blocks.block(b);
    refresh_halo(blocks, block, now, box);
    OverlapWatch watch;
    this->evaluate(block, now, force, watch);
    Kick const kick(table, time_step);
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(species.data() + block.first + i);
      Pack const k = kick.per_mass(big);
      simd::store_records(trial.record.data() + block.first + i,
                          {k * f.x, k * f.y, kick.per_inertia(big) * f.turn, f.count});
    }
    return {0, simd::largest(watch.largest), watch.touching, 0};
  }

  /// Second half: the damping of the changes, and the state at t + dt. seen(slot, records): called with
  /// the new motion of each pack of disks.
  template <class Watch>
  BlockReport correct(std::uint32_t b, ShearedBox const& box, Force* force, Watch&& seen) const {
    using simd::Pack;
    Block const& block = blocks.block(b);
    copy_halo(block);
    for (std::uint32_t i = 0; i < block.local(); ++i) force[i] = Force{};
    look<false>(block, force, NoPackObserver{});
    Kick const kick(table, time_step);
    Pack fastest2 = 0.0, poison = 0.0;
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(now.record.data() + slot);
      auto const change = simd::load_records(trial.record.data() + slot);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(species.data() + slot);
      Pack const k = kick.per_mass(big);
      r.vx += fma(k, f.x, change.x);
      r.vy += fma(k, f.y, change.y);
      r.x = fma(time_step, r.vx, r.x);
      r.y = fma(time_step, r.vy, r.y);
      simd::store_records(now.record.data() + slot, r);
      seen(slot, r);
      if constexpr (rotates)
        (Pack::load(now.spin.data() + slot) + fma(kick.per_inertia(big), f.turn, change.vx))
            .store(now.spin.data() + slot);
      Pack const ux = fnma(box.strain_rate, r.y, r.vx);
      Pack const speed2 = fma(ux, ux, r.vy * r.vy);
      fastest2 = max(fastest2, speed2);
      poison = fma(speed2 + r.x, 0.0, poison);
    }
    return {simd::largest(fastest2), 0, 0, simd::sum(poison)};
  }

  /// Sees all pairs of the inner list, both looks together; between the two halves of a step. force:
  /// not used.
  template <class Observer>
  void observe(Block const& block, ShearedBox const&, Force* force, Observer&& observer) const {
    copy_halo(block);
    look<true>(block, force, observer);
  }

 private:
  /// A change is the same for all images.
  void copy_halo(Block const& block) const {
    auto const* halo = blocks.halo.data() + block.halo_first;
    auto* const record = trial.record.data();
    for (std::uint32_t h = 0; h < block.halo; ++h)
      record[block.first + block.padded + h] = record[halo[h].index()];
  }

  template <bool Whole, class Observer>
  void look(Block const& block, Force* force, Observer&& observe) const {
    SecondLook const shares(forces.law, table, time_step);
    for (int c = 0; c < pair_classes; ++c)
      look_at_class<Whole>(c, block, blocks.near[inner_list].data() + block.pairs[c],
                           block.near[inner_list][c], Pack::load(shares.normal[c]),
                           Pack::load(shares.tangential[c]), force, observe);
  }

  using Pack = simd::Pack;

  /// Adds the forces of the second look, or shows those of both looks together.
  template <bool Whole, class Observer>
  void look_at_class(int pair_class, Block const& block, simd::LocalPair const* pairs,
                     std::uint32_t count, Pack share_normal, Pack share_tangential, Force* force,
                     Observer& observe) const {
    Real const distance = class_distance(pair_class);
    Pack const reach2 = distance * distance, inverse_distance = 1 / distance;
    Law const law = forces.law;
    Repulsion const repulsion = forces.repulsion;
    Real const diameter_a = pair_class == 2 ? big_diameter : small_diameter;
    Real const diameter_b = pair_class == 0 ? small_diameter : big_diameter;
    auto const* const records = now.record.data() + block.first;
    auto const* const changes = trial.record.data() + block.first;
    for (std::uint32_t k = 0; k < count; k += simd::width) {
      auto const d = simd::load_differences(records, pairs + k);
      auto const a = simd::load_first(changes, pairs + k), b = simd::load_second(changes, pairs + k);
      Pack const distance2 = fma(d.x, d.x, d.y * d.y);
      simd::Mask const touching = distance2 < reach2;
      Pack const inverse = inverse_sqrt(distance2);
      Vec2<Pack> const separation{d.x, d.y};
      Contact<Pack> contact;
      contact.normal = inverse * separation;
      contact.relative_overlap = Pack(1.0) - distance2 * inverse * inverse_distance;
      contact.inverse_distance = inverse_distance;
      Vec2<Pack> change{a.x - b.x, a.y - b.y};
      auto const turned = [&](Pack const& spins) {
        return (0.5 * inverse_distance * spins) * perpendicular(separation);
      };
      if constexpr (rotates) change = change - turned(fma(diameter_a, a.vx, diameter_b * b.vx));
      Pack const most = max(a.vy, b.vy);
      Pack const normal = look_up(share_normal, most);
      Pack const tangential = rotates ? look_up(share_tangential, most) : normal;
      contact.velocity = looked_at<Law>(change, contact.normal, normal, tangential);
      if constexpr (Whole) {
        Vec2<Pack> velocity{d.vx, d.vy};
        if constexpr (rotates)
          velocity = velocity -
                     turned(diameter_a * simd::load_sums(now.spin.data() + block.first, pairs + k,
                                                         diameter_b / diameter_a));
        contact.velocity = contact.velocity + velocity;
        PairForce<Pack> const f{separation, repulsion.magnitude(contact) * contact.normal,
                                law.dissipative_force(contact), contact.relative_overlap,
                                velocity + Pack(0.5) * change};
        observe(PackOfPairs{pairs + k, touching, f});
      } else {
        PairForce<Pack> const f{separation, {}, law.dissipative_force(contact), {}, {}};
        Pack turn = 0.0;
        if constexpr (rotates) turn = zero_unless(touching, f.turn(inverse_distance));
        simd::scatter(force, pairs + k, zero_unless(touching, f.dissipative.x),
                      zero_unless(touching, f.dissipative.y), turn);
      }
    }
  }
};

}  // namespace bagnold
