// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "kernels/cpu/steps/ask_ahead.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/cpu/steps/contact_lister.hpp"
#include "kernels/cpu/steps/kick.hpp"
#include "kernels/physics/schemes/damping_bound.hpp"
#include "kernels/physics/schemes/forms.hpp"

namespace bagnold {

/// Step of an ImplicitScheme on a block. `trial` holds a, the changes by the forces. The system
/// solves (ImplicitSolve): each iteration is a pass of all blocks through the pairs that touch,
/// which the first half lists.
template <ContactLaw L, class R, ImplicitScheme S>
struct BlockStep<L, R, S> {
  using Law = L;
  using Repulsion = R;
  using Scheme = S;
  static constexpr bool rotates = Law::rotates;
  using Forces = BlockForces<Law, Repulsion, true>;
  using Force = typename Forces::Force;

  static constexpr int observed_forces = 1;
  static constexpr StepNeeds needs{.rotates = rotates,
                                   .lists_contacts = true,
                                   .trial_spins = false,
                                   .trial_is_change = true,
                                   .evaluations = 1,
                                   .observed_forces = observed_forces,
                                   .force_bytes = sizeof(Force),
                                   .costs = {},
                                   .terms = Scheme::terms(rotates)};

  Forces forces;
  Real time_step;  ///< dt, [tau_e]
  DampingBound bound;

  BlockStep(Law const& law, Repulsion const& repulsion, SpeciesTable const& table, Real dt,
            std::unique_ptr<BlockDrive<Force, rotates> const>)
      : forces{law, repulsion}, time_step(dt), bound(DampingBound::of(law, table)) {}

  /// First half: the changes by the forces at t. force: scratch, [most_local].
  BlockReport predict(BlockSystem const& s, std::uint32_t b, ShearedBox const& box,
                      Force* force) const {
    Block const& block = s.blocks.block(b);
    refresh_halo(s.blocks, block, s.now, box);
    bring_near(s.blocks, block, s.trial);
    Forces::clear(block, force);
    BlockReport report = add_and_list(forces, s, b, force);
    Kick const kick(s.table, time_step);
    Pack most_small = 0.0, most_big = 0.0;
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(s.species.data() + block.first + i);
      auto const v = Scheme::change(f.force(), kick.per_mass(big));
      Pack const spin = Scheme::change(f.torque_per_diameter, kick.per_inertia(big));
      simd::store_records(s.trial.record.data() + block.first + i, {v.x, 0.0, v.y, spin});
      Pack const of_big = zero_unless(big, f.count);
      most_big = max(most_big, of_big);
      most_small = max(most_small, f.count - of_big);
    }
    if constexpr (rotates) keep_separations(s, block);
    report.coupling =
        weighed_time_step() * std::max(bound(0, static_cast<int>(simd::largest(most_small))),
                                       bound(1, static_cast<int>(simd::largest(most_big))));
    return report;
  }

  /// Iteration k of the system's solve, into ImplicitSolve::next.
  void iterate(BlockSystem const& s, std::uint32_t b, int k, Force* force) const {
    Block const& block = s.blocks.block(b);
    asking_ahead(s, b, k, [&](auto&& ask) {
      iterate(s, block, k, force, s.implicit.next(k).data() + block.first, ask);
    });
  }

  /// Second half: the last iteration, and the state at t + dt. observed: measure() has done the
  /// last iteration already.
  template <class Seen>
  BlockReport correct(BlockSystem const& s, std::uint32_t b, ShearedBox const& box, Force* force,
                      bool observed, Seen const& seen) const {
    Block const& block = s.blocks.block(b);
    auto const* change = s.implicit.solution().data() + block.first;
    if (!observed) {
      auto* const in_place = reinterpret_cast<simd::Record*>(force);
      asking_ahead(s, b, second_half_of_step, contact_list, [&](auto&& ask) {
        iterate(s, block, s.implicit.passes() - 1, force, in_place, ask);
      });
      change = in_place;
    }
    SpeedBound speeds{box.strain_rate};
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(s.now.record.data() + slot);
      auto const w = load_motions(change + i);
      auto const after = Scheme::velocity(r.velocity(), w.velocity);
      r = simd::make_records(Scheme::position(r.position(), after, Pack(time_step)), after);
      simd::store_records(s.now.record.data() + slot, r);
      seen(slot, r);
      if constexpr (rotates) {
        auto* const spin = s.now.spin.data() + slot;
        Scheme::velocity(Pack::load(spin), w.spin).store(spin);
      }
      speeds(r, r.y);
    }
    return {.fastest2 = simd::largest(speeds.fastest2), .nan_flag = simd::sum(speeds.nan_flag)};
  }

  /// Shows the pairs that touch to an observer, as ImplicitForces does. force: [most_local], out:
  /// the damping of w.
  template <class Observer>
  void observe(BlockSystem const& s, Block const& block, Force* force, Observer&& observer) const {
    auto const& w = s.implicit.solution();
    copy_halo(s.blocks, block, w);
    Forces::clear(block, force);
    each_contact(s, block, w.data() + block.first,
                 [&](simd::LocalPair const* pairs, simd::Mask touching, int pair_class,
                     simd::Records const& d, Contact<Pack> contact) {
                   Pack const inverse_distance = contact.inverse_distance;
                   PairForce<Pack> f{{d.x, d.y},
                                     forces.repulsion.magnitude(contact) * contact.normal,
                                     forces.law.dissipative_force(contact),
                                     contact.relative_overlap,
                                     {}};
                   scatter(force, pairs, touching, f, inverse_distance);
                   Pack spins = 0.0;
                   if constexpr (rotates)
                     spins =
                         first_diameter(pair_class) *
                         simd::load_sums(s.now.spin.data() + block.first, pairs,
                                         second_diameter(pair_class) / first_diameter(pair_class));
                   auto const velocity = velocity_at_contact<Law>({d.vx, d.vy}, f.separation,
                                                                  inverse_distance, spins);
                   f.velocity = velocity + Pack(0.5) * contact.velocity;
                   contact.velocity = velocity + Pack(Scheme::theta) * contact.velocity;
                   f.dissipative = forces.law.dissipative_force(contact);
                   observer(PackOfPairs{pairs, touching, f});
                 });
  }

  DrivePower drive_power(BlockSystem const&, Block const&, Real, Force const*) const { return {}; }

  /// Powers of a pack of disks from i on, after observe(), as in ImplicitForces. r, spin: of these
  /// disks.
  PackPower observed_power(BlockSystem const& s, Block const& block, Force const* force,
                           std::uint32_t i, simd::Mask big, simd::Records const& r, simd::Pack spin,
                           Real strain_rate) const {
    auto const slot = block.first + i;
    auto const a = load_motions(s.trial.record.data() + slot),
               w = load_motions(s.implicit.solution().data() + slot);
    auto const f = simd::load_forces(force + i);
    Kick const weighed(s.table, weighed_time_step());
    auto const left = a.velocity - w.velocity + weighed.per_mass(big) * f.force();
    Vec2<Pack> const halfway =
        Vec2<Pack>{peculiar_x(r.vx, r.y, strain_rate), r.vy} + Pack(0.5) * w.velocity;
    auto const rate = [&](PerSpecies const& inverse) {
      return select(big, Pack(1 / (time_step * inverse[1])), Pack(1 / (time_step * inverse[0])));
    };
    PackPower power;
    power.dissipation = rate(s.table.inverse_mass) * dot(left, halfway);
    if constexpr (rotates) {
      Pack const inertia_rate = rate(s.table.inverse_inertia);
      Pack const turning = fma(0.5, w.spin, spin);
      Pack const turn_left = a.spin - w.spin + weighed.per_inertia(big) * f.torque_per_diameter;
      power.dissipation += turn_left * turning * inertia_rate;
      power.torque = w.spin * turning * inertia_rate;
    }
    return power;
  }

 private:
  using Pack = simd::Pack;

  Real weighed_time_step() const { return Scheme::theta * time_step; }

  static Real first_diameter(int pair_class) {
    return pair_class == 2 ? big_diameter : small_diameter;
  }
  static Real second_diameter(int pair_class) {
    return pair_class == 0 ? small_diameter : big_diameter;
  }

  struct Motions {
    Vec2<Pack> velocity;
    Pack spin;
  };

  /// Motions of a pack of disks, from records {v_x, -, v_y, thetadot}: the order of TurningForce.
  BAGNOLD_INLINE static Motions load_motions(simd::Record const* records) {
    auto const r = simd::load_records(records);
    return {{r.x, r.vx}, r.vy};
  }

  /// Four numbers of a record or of a TurningForce.
  using Row [[gnu::vector_size(32), gnu::may_alias]] = double;
  static_assert(sizeof(Force) == sizeof(simd::Record));  // w may be made where the forces are

  template <class T>
  BAGNOLD_INLINE static Row row(T const* at) {
    static_assert(sizeof(T) == sizeof(Row) && alignof(T) >= alignof(Row));  // 16 without AVX
    return *reinterpret_cast<Row const*>(at);
  }
  BAGNOLD_INLINE static void put(simd::Record* at, Row const& row) {
    *reinterpret_cast<Row*>(at) = row;
  }

  /// Factors by which a force on a disk, acting for a time, changes its motion, in the order of a
  /// row.
  struct RowBySpecies {
    Row row[2];

    RowBySpecies(SpeciesTable const& table, Real time) {
      for (Species s = 0; s < 2; ++s) {
        Real const mass = time * table.inverse_mass[s];
        row[s] = Row{mass, 0, mass, time * table.diameter[s] * table.inverse_inertia[s]};
      }
    }
  };

  /// to: [block.padded]; may be the array of forces. ask(): called for each pack of pairs.
  template <class Ask>
  void iterate(BlockSystem const& s, Block const& block, int k, Force* force, simd::Record* to,
               Ask&& ask) const {
    auto const& solve = s.implicit;
    auto const& now = solve.now(k, s.trial.record);
    copy_halo(s.blocks, block, now);
    Forces::clear(block, force);
    add_damping(s, block, now.data() + block.first, force, ask);
    auto const by = solve.iterations.iteration[k];
    auto const* const start = s.trial.record.data() + block.first;
    auto const* const before = now.data() + block.first;
    RowBySpecies const per(s.table, by.of_coupling * weighed_time_step());
    for (std::uint32_t i = 0; i < block.padded; ++i) {
      Row const kept = by.of_now * row(before + i) + by.of_start * row(start + i);
      put(to + i, per.row[s.species(block.first + i)] * row(force + i) + kept);
    }
  }

  /// Damping of disks that move as the records say.
  template <class Ask>
  void add_damping(BlockSystem const& s, Block const& block, simd::Record const* moving,
                   Force* force, Ask&& ask) const {
    auto const* const records = s.now.record.data() + block.first;
    Law const law = forces.law;
    for (int c = 0; c < pair_classes; ++c) {
      auto const count = block.near[contact_list][c];
      if (count == 0) continue;
      auto const* const pairs = s.blocks.near[contact_list].data() + block.pairs[c];
      Pack const inverse_distance = 1 / class_distance(c);
      Real const diameter = first_diameter(c);
      simd::Record const weight = weight_of(c);
      auto next = simd::load_combined(moving, pairs, weight);
      for (std::uint32_t k = 0; k < count; k += simd::width) {
        auto const u = next;
        next = simd::load_combined(moving, pairs + (k + simd::width < count ? k + simd::width : 0),
                                   weight);
        auto const separation = separation_of(s, block.pairs[c] + k, records);
        Contact<Pack> contact =
            make_contact(separation, dot(separation, separation), inverse_distance);
        contact.velocity =
            velocity_at_contact<Law>({u.x, u.vx}, separation, inverse_distance, diameter * u.vy);
        PairForce<Pack> const f{separation, {}, law.dissipative_force(contact), {}, {}};
        scatter(force, pairs + k, simd::first_lanes(count - k), f, inverse_distance);
        ask();
      }
    }
  }

  /// Separations of a pack of pairs of the contact list, by its place in the list: as saved if the
  /// law rotates.
  BAGNOLD_INLINE static Vec2<Pack> separation_of(BlockSystem const& s, std::uint32_t at,
                                                 simd::Record const* records) {
    if constexpr (rotates) {
      auto const* const kept = s.implicit.separation.data() + 2 * at;
      return {Pack::load(kept), Pack::load(kept + simd::width)};
    } else {
      auto const d = simd::load_differences(records, s.blocks.near[contact_list].data() + at);
      return {d.x, d.y};
    }
  }

  void keep_separations(BlockSystem const& s, Block const& block) const {
    auto const* const records = s.now.record.data() + block.first;
    for (int c = 0; c < pair_classes; ++c)
      for (std::uint32_t k = 0; k < block.near[contact_list][c]; k += simd::width) {
        auto const at = block.pairs[c] + k;
        auto const d = simd::load_differences(records, s.blocks.near[contact_list].data() + at);
        auto* const kept = s.implicit.separation.data() + 2 * at;
        d.x.store(kept);
        d.y.store(kept + simd::width);
      }
  }

  static simd::Record weight_of(int pair_class) {
    return {-1, 0, -1, second_diameter(pair_class) / first_diameter(pair_class)};
  }

  /// Data of a pack of pairs, loaded before the previous pack is evaluated.
  struct Loaded {
    simd::Records now, moving;
  };
  BAGNOLD_INLINE static Loaded load(simd::LocalPair const* pairs, simd::Record const* records,
                                    simd::Record const* moving, simd::Record const& weight) {
    return {simd::load_differences(records, pairs), simd::load_combined(moving, pairs, weight)};
  }

  /// Calls visit(pairs, touching, class, difference of the records, contact) for the listed pairs.
  /// The contact's velocity is that of disks that move as `moving` says.
  template <class Visit>
  void each_contact(BlockSystem const& s, Block const& block, simd::Record const* moving,
                    Visit const& visit) const {
    auto const* const records = s.now.record.data() + block.first;
    for (int c = 0; c < pair_classes; ++c) {
      auto const* const pairs = s.blocks.near[contact_list].data() + block.pairs[c];
      auto const count = block.near[contact_list][c];
      if (count == 0) continue;
      Pack const inverse_distance = 1 / class_distance(c);
      Real const diameter = first_diameter(c);
      simd::Record const weight = weight_of(c);
      Loaded next = load(pairs, records, moving, weight);
      for (std::uint32_t k = 0; k < count; k += simd::width) {
        auto const [d, u] = next;
        next =
            load(pairs + (k + simd::width < count ? k + simd::width : 0), records, moving, weight);
        Vec2<Pack> const separation{d.x, d.y};
        Contact<Pack> contact =
            make_contact(separation, fma(d.x, d.x, d.y * d.y), inverse_distance);
        contact.velocity =
            velocity_at_contact<Law>({u.x, u.vx}, separation, inverse_distance, diameter * u.vy);
        visit(pairs + k, simd::first_lanes(count - k), c, d, contact);
      }
    }
  }

  BAGNOLD_INLINE static void scatter(Force* force, simd::LocalPair const* pairs,
                                     simd::Mask touching, PairForce<Pack> const& f,
                                     Pack const& inverse_distance) {
    Pack torque_per_diameter = 0.0;
    if constexpr (rotates)
      torque_per_diameter = zero_unless(touching, f.torque_per_diameter(inverse_distance));
    simd::scatter(force, pairs, zero_unless(touching, f.dissipative.x),
                  zero_unless(touching, f.dissipative.y), torque_per_diameter);
  }
};

}  // namespace bagnold
