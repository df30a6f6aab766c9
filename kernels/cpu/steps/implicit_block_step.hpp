// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <type_traits>

#include "kernels/cpu/steps/ask_ahead.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "kernels/cpu/steps/contact_lister.hpp"
#include "kernels/cpu/steps/kick.hpp"
#include "kernels/physics/schemes/chebyshev.hpp"
#include "kernels/physics/schemes/damping_bound.hpp"
#include "kernels/physics/schemes/forms.hpp"

namespace bagnold {

/// Step of an ImplicitScheme on a block. `trial` holds a, the changes by the forces. Each iteration
/// for w, the changes of all motions, is a pass through the pairs that touch, which the first half
/// lists. Iteration k makes w_k+2 from w_k+1; the two arrays of more_records hold them in turns, a
/// record {v_x, v_y, thetadot, -} a disk.
template <ContactLaw L, class R, ImplicitScheme S>
struct BlockStep<L, R, S> {
  using Law = L;
  using Repulsion = R;
  using Scheme = S;
  static constexpr bool rotates = Law::rotates;
  using Forces = BlockForces<Law, Repulsion, true>;
  using Force = typename Forces::Force;

  static constexpr int iterations = Scheme::terms(rotates) - 1;
  static constexpr StepCosts costs{};
  static constexpr std::size_t scratch = sizeof(Force);

  Forces forces;
  Real time_step;  ///< dt, [tau_e]
  DampingBound bound;
  ChebyshevRoots roots = ChebyshevRoots::make(iterations + 1, Scheme::lift);

  BlockStep(Law const& law, Repulsion const& repulsion, SpeciesTable const& table, Real dt)
      : forces{law, repulsion}, time_step(dt), bound(DampingBound::of(law, table)) {}

  /// Sums need the last iterate of all disks; without them it is made in the scratch.
  template <class Add>
  static void each_pass(Add const& add) {
    unsigned const separations = rotates ? +Uses::separations : 0;
    add(&BlockStep::predict, {.awaits = Awaits::neighbours,
                              .uses = Uses::near_pairs | Uses::contact_pairs | Uses::changes |
                                      Uses::iterates | separations});
    for (int k = 0; k < iterations - 1; ++k) add(&BlockStep::iterate, {Awaits::all});
    add(&BlockStep::iterate, {Awaits::all, When::sampled});
    add(&BlockStep::iterate_in_place, {Awaits::all, When::unsampled});
    add(&BlockStep::measure_pairs, {Awaits::all, When::sampled});
    add(&BlockStep::measure_disks, {.when = When::sampled});
    add(&BlockStep::move);
  }

  /// First half: the changes by the forces at t. force: scratch, [most_local].
  BlockReport predict(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    Block const& block = s.blocks.block(b);
    refresh_halo(s.blocks, block, s.now, at.box);
    bring_near(s.blocks, block, s.trial);
    Forces::clear(block, force);
    BlockReport report = add_and_list(forces, s, b, at, force);
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

  /// Iteration of a pass, the first of which follows the first half.
  BlockReport iterate(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    Block const& block = s.blocks.block(b);
    int const k = at.pass - 1;
    auto const& to = s.more_records[k % 2];
    auto const body = [&](auto&& ask) {
      iterate(s, block, at, k, force, to.data() + block.first, ask);
    };
    auto const& now = iterate_of(s, k);
    if (k == 0)
      asking_ahead<10>(s, b, at, body, now, Arrays{&now, &to});
    else
      asking_ahead<10>(s, b, at, body, now, Arrays{&s.trial.record, &now, &to});
    return {};
  }

  /// The last iteration, whose result takes the place of the forces.
  BlockReport iterate_in_place(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                               Force* force) const {
    Block const& block = s.blocks.block(b);
    auto const body = [&](auto&& ask) {
      iterate(s, block, at, iterations - 1, force, reinterpret_cast<simd::Record*>(force), ask);
    };
    asking_ahead(s, b, at, body, contact_list, s.trial);
    return {};
  }

  /// The state at t + dt.
  BlockReport move(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    Block const& block = s.blocks.block(b);
    auto const* const change = at.sums == nullptr ? reinterpret_cast<simd::Record const*>(force)
                                                  : solution(s).data() + block.first;
    SpeedBound speeds{at.next_box.strain_rate};
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(s.now.record.data() + slot);
      auto const w = load_motions(change + i);
      auto const after = Scheme::velocity(r.velocity(), w.velocity);
      r = simd::make_records(Scheme::position(r.position(), after, Pack(time_step)), after);
      simd::store_records(s.now.record.data() + slot, r);
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
    auto const& w = solution(s);
    copy_halo(s.blocks, block, w);
    Forces::clear(block, force);
    double const* spins = nullptr;
    if constexpr (rotates) spins = s.now.spin.data() + block.first;
    for (int c = 0; c < pair_classes; ++c) {
      PairClass const of(c);
      each_pack(
          s.blocks, block, contact_list, c,
          Show<std::remove_reference_t<Observer>>{of, weight_of(of), forces.law, forces.repulsion,
                                                  s.now.record.data() + block.first,
                                                  w.data() + block.first, spins, force, observer});
    }
  }

  /// Sums of the configuration where the step began.
  BlockReport measure_pairs(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                            Force* force) const {
    return sum_pairs(*this, s, b, at, force);
  }
  BlockReport measure_disks(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                            Force* force) const {
    return sum_disks(*this, s, b, at, force);
  }

  /// Powers of a pack of disks from i on, after observe(), as in ImplicitForces. r, spin: of these
  /// disks.
  PackPower observed_power(BlockSystem const& s, Block const& block, Force const* force,
                           std::uint32_t i, simd::Mask big, simd::Records const& r, simd::Pack spin,
                           Real strain_rate) const {
    auto const slot = block.first + i;
    auto const a = load_motions(s.trial.record.data() + slot),
               w = load_motions(solution(s).data() + slot);
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
  using Records = Blocks::Array<simd::Record>;
  using Arrays = std::initializer_list<Records const*>;

  /// w_k+1, from which iteration k starts: a for w_1.
  static Records const& iterate_of(BlockSystem const& s, int k) {
    return k == 0 ? s.trial.record : s.more_records[(k - 1) % 2];
  }
  static Records const& solution(BlockSystem const& s) {
    return s.more_records[(iterations - 1) % 2];
  }

  Real weighed_time_step() const { return Scheme::theta * time_step; }

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
  void iterate(BlockSystem const& s, Block const& block, StepAt const& at, int k, Force* force,
               simd::Record* to, Ask&& ask) const {
    auto const& now = iterate_of(s, k);
    copy_halo(s.blocks, block, now);
    Forces::clear(block, force);
    add_damping(s, block, now.data() + block.first, force, ask);
    auto const by = ChebyshevIterations(at.total.coupling, roots).iteration[k];
    auto const* const start = s.trial.record.data() + block.first;
    auto const* const before = now.data() + block.first;
    RowBySpecies const per(s.table, by.of_coupling * weighed_time_step());
    for (std::uint32_t i = 0; i < block.padded; ++i) {
      Row const kept = by.of_now * row(before + i) + by.of_start * row(start + i);
      put(to + i, per.row[s.species(block.first + i)] * row(force + i) + kept);
    }
  }

  /// Contact of disks that move as a pack of combined records says.
  BAGNOLD_INLINE static Contact<Pack> contact_of(PairClass const& of, Vec2<Pack> const& separation,
                                                 Pack const& distance2,
                                                 simd::Records const& moving) {
    Contact<Pack> contact = make_contact(separation, distance2, of.inverse_distance);
    contact.velocity = velocity_at_contact<Law>({moving.x, moving.vx}, separation,
                                                of.inverse_distance, of.diameter * moving.vy);
    return contact;
  }

  static simd::Record weight_of(PairClass const& of) { return {-1, 0, -1, of.ratio}; }

  /// Damping of disks that move as the records say.
  template <class Ask>
  void add_damping(BlockSystem const& s, Block const& block, simd::Record const* moving,
                   Force* force, Ask& ask) const {
    for (int c = 0; c < pair_classes; ++c) {
      PairClass const of(c);
      each_pack(s.blocks, block, contact_list, c,
                Damp<Ask>{of, weight_of(of), forces.law, moving, s.now.record.data() + block.first,
                          s.blocks.near[contact_list].data(), s.of_pairs.data(), force, ask});
    }
  }

  /// Body of the pair loop of an iteration.
  template <class Ask>
  struct Damp {
    PairClass of;
    simd::Record weight;
    Law law;
    simd::Record const *moving, *records;
    simd::LocalPair const* list;  ///< of all blocks
    double const* kept;           ///< separations, if the law rotates
    Force* force;
    Ask& ask;

    BAGNOLD_INLINE simd::Records load(simd::LocalPair const* pairs) const {
      return simd::load_combined(moving, pairs, weight);
    }

    BAGNOLD_INLINE void operator()(simd::LocalPair const* pairs, std::uint32_t left,
                                   simd::Records const& u) const {
      auto const separation = separation_of(pairs);
      PairForce<Pack> const f{
          separation,
          {},
          law.dissipative_force(contact_of(of, separation, dot(separation, separation), u)),
          {},
          {}};
      scatter_damping(force, pairs, simd::first_lanes(left), f, rotates, of.inverse_distance);
      ask();
    }

    BAGNOLD_INLINE Vec2<Pack> separation_of(simd::LocalPair const* pairs) const {
      if constexpr (rotates) {
        auto const* const at = kept + 2 * (pairs - list);
        return {Pack::load(at), Pack::load(at + simd::width)};
      } else {
        auto const d = simd::load_differences(records, pairs);
        return {d.x, d.y};
      }
    }
  };

  void keep_separations(BlockSystem const& s, Block const& block) const {
    auto const* const records = s.now.record.data() + block.first;
    for (int c = 0; c < pair_classes; ++c)
      for (std::uint32_t k = 0; k < block.near[contact_list][c]; k += simd::width) {
        auto const at = block.pairs[c] + k;
        auto const d = simd::load_differences(records, s.blocks.near[contact_list].data() + at);
        auto* const kept = s.of_pairs.data() + 2 * at;
        d.x.store(kept);
        d.y.store(kept + simd::width);
      }
  }

  /// Body of the pair loop that shows the forces of a step to an observer.
  template <class Observer>
  struct Show {
    struct Data {
      simd::Records now, change;
    };

    PairClass of;
    simd::Record weight;
    Law law;
    Repulsion repulsion;
    simd::Record const *records, *changes;
    double const* spins;
    Force* force;
    Observer& observe;

    BAGNOLD_INLINE Data load(simd::LocalPair const* pairs) const {
      return {simd::load_differences(records, pairs), simd::load_combined(changes, pairs, weight)};
    }

    BAGNOLD_INLINE void operator()(simd::LocalPair const* pairs, std::uint32_t left,
                                   Data const& data) const {
      auto const& [d, w] = data;
      auto const touching = simd::first_lanes(left);
      Vec2<Pack> const separation{d.x, d.y};
      auto contact = contact_of(of, separation, fma(d.x, d.x, d.y * d.y), w);
      auto const change = contact.velocity;
      scatter_damping(force, pairs, touching,
                      {separation, {}, law.dissipative_force(contact), {}, {}}, rotates,
                      of.inverse_distance);
      Pack spin = 0.0;
      if constexpr (rotates) spin = simd::load_sums(spins, pairs, of.ratio);
      auto const velocity = velocity_at_contact<Law>({d.vx, d.vy}, separation, of.inverse_distance,
                                                     of.diameter * spin);
      contact.velocity = velocity + Pack(Scheme::theta) * change;
      auto const f =
          force_of_contact(law, repulsion, separation, contact, velocity + Pack(0.5) * change);
      observe(PackOfPairs{pairs, touching, f});
    }
  };
};

}  // namespace bagnold
