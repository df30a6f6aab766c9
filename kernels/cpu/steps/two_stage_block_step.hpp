// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "kernels/cpu/steps/ask_ahead.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "kernels/cpu/steps/contact_lister.hpp"
#include "kernels/cpu/steps/kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/second_stage.hpp"

namespace bagnold {

/// Step of a TwoStageScheme on a block. `trial` holds the changes of the first stage: a record
/// {v_x, v_y, thetadot, contacts} a disk. The first stage lists the pairs that touch for the second
/// one.
template <TwoStageLaw L, class R, TwoStageScheme S>
struct BlockStep<L, R, S> {
  using Law = L;
  using Repulsion = R;
  using Scheme = S;
  static constexpr bool rotates = Law::rotates;
  using Forces = BlockForces<Law, Repulsion, true>;
  using Force = typename Forces::Force;

  static constexpr StepCosts costs{.by_itself = 5, .contact = 33, .few_below = 0.6};
  static constexpr std::size_t scratch = 2 * sizeof(Force);

  Forces forces;
  Real time_step;  ///< dt, [tau_e]
  SecondStage shares;

  BlockStep(Law const& law, Repulsion const& repulsion, SpeciesTable const& table, Real dt)
      : forces{law, repulsion}, time_step(dt), shares(SecondStage::of<Scheme>(law, table, dt)) {}

  template <class Add>
  static void each_pass(Add const& add) {
    add(&BlockStep::evaluate, {.awaits = Awaits::neighbours,
                               .uses = Uses::near_pairs | Uses::contact_pairs | Uses::changes});
    add(DrivePart::force);
    add(&BlockStep::change);
    add(&BlockStep::measure_pairs, {Awaits::neighbours, When::sampled});
    add(&BlockStep::damp, {Awaits::neighbours, When::unsampled});
    add(DrivePart::second);
    add(&BlockStep::measure_disks, {.when = When::sampled});
    add(DrivePart::powers_of_both);
    add(&BlockStep::move);
  }

  template <class Add>
  static void each_pass_for_few(Add const& add) {
    add(&BlockStep::evaluate_few, {Awaits::neighbours});
    add(&BlockStep::measure_pairs, {Awaits::neighbours, When::sampled});
    add(&BlockStep::damp_few, {Awaits::neighbours, When::unsampled});
    add(&BlockStep::measure_disks, {.when = When::sampled});
    add(&BlockStep::move_few);
  }

  SecondStage const* second_stage() const { return &shares; }

  /// Forces at t. force: scratch, [most_local].
  BlockReport evaluate(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                       Force* force) const {
    Block const& block = s.blocks.block(b);
    refresh_halo(s.blocks, block, s.now, at.box);
    bring_near(s.blocks, block, s.trial);
    Forces::clear(block, force);
    return add_and_list(forces, s, b, at, force);
  }

  /// First stage: the changes by the forces.
  BlockReport change(BlockSystem const& s, std::uint32_t b, StepAt const&, Force* force) const {
    Block const& block = s.blocks.block(b);
    Kick const kick(s.table, time_step);
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(s.species.data() + block.first + i);
      simd::store_records(s.trial.record.data() + block.first + i, change_of(kick, f, big));
    }
    return {};
  }

  /// Second stage: the damping of the changes.
  BlockReport damp(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    Block const& block = s.blocks.block(b);
    Forces::clear(block, force);
    asking_ahead(
        s, b, at, [&](auto&& ask) { add_second(s, block, force, ask); }, contact_list, s.trial);
    return {};
  }

  /// The state at t + dt.
  BlockReport move(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* scratch) const {
    Block const& block = s.blocks.block(b);
    auto const* const force = second_forces(s, at, scratch);
    Kick const kick(s.table, time_step);
    SpeedBound speeds{at.next_box.strain_rate};
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(s.now.record.data() + slot);
      auto const change = simd::load_records(s.trial.record.data() + slot);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(s.species.data() + slot);
      auto const after = accelerated(r, change, f, kick.per_mass(big));
      r = simd::make_records(Scheme::position(r.position(), after, Pack(time_step)), after);
      simd::store_records(s.now.record.data() + slot, r);
      if constexpr (rotates) {
        auto* const spin = s.now.spin.data() + slot;
        spun(Pack::load(spin), change, f, kick.per_inertia(big)).store(spin);
      }
      speeds(r, r.y);
    }
    return {simd::largest(speeds.fastest2), 0, 0, simd::sum(speeds.nan_flag)};
  }

  /// Forces and first stage where few of the near pairs touch.
  BlockReport evaluate_few(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                           Force* force) const {
    Block const& block = s.blocks.block(b);
    ActiveDisks const& active = *at.active;
    auto* const change = s.trial.record.data() + block.first;
    refresh_halo(s.blocks, block, s.now, at.box);
    auto const* const before = active.list.data() + block.first;
    for (std::uint32_t k = 0; k < active.count(b); ++k) simd::at(change, before[k]) = {};
    active.count(b) = 0;
    active.find(s.blocks, b, s.now.record.data() + block.first, force);
    OverlapBound overlaps;
    forces.add(s, block, contact_list, s.now, force, overlaps);
    Kick const kick(s.table, time_step);
    active.each_pack(block, active.count(b), s.species.data(),
                     [&](std::uint16_t const* index4, simd::Mask big) {
                       simd::store_records(change, index4,
                                           change_of(kick, simd::load_forces(force, index4), big));
                     });
    return {0, simd::largest(overlaps.largest), overlaps.touching, 0};
  }

  /// Second stage where few of the near pairs touch.
  BlockReport damp_few(BlockSystem const& s, std::uint32_t b, StepAt const&, Force* force) const {
    Block const& block = s.blocks.block(b);
    clear_touching(s, block, force);
    add_second(s, block, force, [] {});
    return {};
  }

  /// The state at t + dt where few of the near pairs touch.
  BlockReport move_few(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                       Force* scratch) const {
    Block const& block = s.blocks.block(b);
    auto* const force = second_forces(s, at, scratch);
    ActiveDisks const& active = *at.active;
    auto* const now = s.now.record.data() + block.first;
    auto* const change = s.trial.record.data() + block.first;
    Kick const kick(s.table, time_step);
    SpeedBound speeds{at.next_box.strain_rate};
    auto const* const list = active.list.data() + block.first;
    for (auto k = active.count(b); k < simd::round_up(active.count(b)); ++k)
      simd::at(force, list[k]) = Force{};
    active.each_pack(
        block, active.count(b), s.species.data(), [&](std::uint16_t const* index4, simd::Mask big) {
          auto r = simd::load_records(now, index4);
          auto const of_first = simd::load_records(change, index4);
          auto const f = simd::load_forces(force, index4);
          r = simd::make_records(r.position(), accelerated(r, of_first, f, kick.per_mass(big)));
          simd::store_records(now, index4, r);
          if constexpr (rotates) {
            auto* const spin = s.now.spin.data() + block.first;
            simd::store(spin, index4,
                        spun(simd::load(spin, index4), of_first, f, kick.per_inertia(big)));
          }
          speeds(r, fma(time_step, r.vy, r.y));
        });
    simd::fly(now, now, block.padded, time_step);
    for (std::uint32_t k = 0; k < active.count(b); ++k)
      active.is_active(block.first + list[k] / 4u) = 0;
    return {simd::largest(speeds.fastest2), 0, 0, simd::sum(speeds.nan_flag)};
  }

  /// Sums of the configuration where the step began. Leave the forces of observe() to move().
  BlockReport measure_pairs(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                            Force* force) const {
    return sum_pairs(*this, s, b, at, force);
  }
  BlockReport measure_disks(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                            Force* force) const {
    return sum_disks(*this, s, b, at, force);
  }

  /// Shows the pairs that touch to an observer, with both stages together, once changes are known.
  /// force: [2][most_local], out: the damping of both stages, and that of the second one.
  template <class Observer>
  void observe(BlockSystem const& s, Block const& block, Force* force, Observer&& observer) const {
    copy_halo(s.blocks, block, s.trial.record);
    Forces::clear(block, force);
    Forces::clear(block, force + s.blocks.most_local);
    add_stage<true>(
        s, block, force, [] {}, observer);
  }

  /// Powers of a pack of disks from i on, after observe(), as in ChangeForces. spin: of these
  /// disks.
  PackPower observed_power(BlockSystem const& s, Block const&, Force const* force, std::uint32_t i,
                           simd::Mask big, simd::Records const&, simd::Pack spin, Real) const {
    auto const both = simd::load_forces(force + i);
    auto const second = simd::load_forces(force + s.blocks.most_local + i);
    Kick const half(s.table, time_step / 2);
    PackPower power;
    power.dissipation = -(half.per_mass(big) * fma(both.x, second.x, both.y * second.y));
    if constexpr (rotates) {
      Pack const torque = diameter_of(big) * both.torque_per_diameter,
                 per_inertia = half.per_inertia(big);
      power.dissipation = fnma(per_inertia * second.torque_per_diameter, torque, power.dissipation);
      power.torque = torque * fma(per_inertia, both.torque_per_diameter, spin);
    }
    return power;
  }

 private:
  using Pack = simd::Pack;

  /// Changes of the first stage, as in `trial`.
  BAGNOLD_INLINE static simd::Records change_of(Kick const& kick, simd::ForceComponents const& f,
                                                simd::Mask big) {
    Pack const most = SecondStage::most;
    auto const v = Scheme::change(f.force(), kick.per_mass(big));
    return {v.x, v.y, Scheme::change(f.torque_per_diameter, kick.per_inertia(big)),
            select(most < f.count, most, f.count)};
  }

  BAGNOLD_INLINE static Vec2<Pack> accelerated(simd::Records const& r, simd::Records const& change,
                                               simd::ForceComponents const& second, Pack per_mass) {
    return Scheme::velocity(r.velocity(), change.position(), second.force(), per_mass);
  }

  BAGNOLD_INLINE static Pack spun(Pack spin, simd::Records const& change,
                                  simd::ForceComponents const& second, Pack per_inertia) {
    return Scheme::velocity(spin, change.vx, second.torque_per_diameter, per_inertia);
  }

  /// Adds the forces of the second stage to force, which is cleared where pairs touch. ask():
  /// called for each pack of pairs.
  template <class Ask>
  void add_second(BlockSystem const& s, Block const& block, Force* force, Ask&& ask) const {
    copy_halo(s.blocks, block, s.trial.record);
    add_stage<false>(s, block, force, ask, NoPackObserver{});
  }

  static void clear_touching(BlockSystem const& s, Block const& block, Force* force) {
    for (int c = 0; c < pair_classes; ++c) {
      auto const* pairs = s.blocks.near[contact_list].data() + block.pairs[c];
      for (std::uint32_t k = 0; k < simd::round_up(block.near[contact_list][c]); ++k)
        simd::at(force, pairs[k].a4) = simd::at(force, pairs[k].b4) = Force{};
    }
  }

  /// Adds the forces of the second stage. If Whole, adds those of both stages and shows them to the
  /// observer.
  template <bool Whole, class Ask, class Observer>
  void add_stage(BlockSystem const& s, Block const& block, Force* force, Ask&& ask,
                 Observer&& observe) const {
    double const* spins = nullptr;
    if constexpr (rotates) spins = s.now.spin.data() + block.first;
    for (int c = 0; c < pair_classes; ++c) {
      PairClass const of(c);
      each_pack(s.blocks, block, contact_list, c,
                Damp<Whole, std::remove_reference_t<Ask>, std::remove_reference_t<Observer>>{
                    of,
                    simd::EightByNumber(shares.normal[c]),
                    simd::EightByNumber(shares.tangential[c]),
                    {-1, -1, of.ratio, simd::CountPairs::base},
                    forces.law,
                    forces.repulsion,
                    s.now.record.data() + block.first,
                    s.trial.record.data() + block.first,
                    spins,
                    force,
                    s.blocks.most_local,
                    ask,
                    observe});
    }
  }

  /// Body of the pair loop of the second stage.
  template <bool Whole, class Ask, class Observer>
  struct Damp {
    struct Data {
      simd::Records now, change;
    };

    PairClass of;
    simd::EightByNumber share_normal, share_tangential;
    simd::Record weight;
    Law law;
    Repulsion repulsion;
    simd::Record const *records, *changes;
    double const* spins;
    Force* force;
    std::uint32_t most_local;
    Ask& ask;
    Observer& observe;

    BAGNOLD_INLINE Data load(simd::LocalPair const* pairs) const {
      return {simd::load_differences(records, pairs), simd::load_combined(changes, pairs, weight)};
    }

    BAGNOLD_INLINE void operator()(simd::LocalPair const* pairs, std::uint32_t left,
                                   Data const& data) const {
      auto const& [d, a] = data;
      auto const touching = simd::first_lanes(left);
      Vec2<Pack> const separation{d.x, d.y};
      auto const at_contact = [&](Pack const& x, Pack const& y, Pack const& spin) {
        return velocity_at_contact<Law>({x, y}, separation, of.inverse_distance,
                                        of.diameter * spin);
      };
      auto const change = at_contact(a.x, a.y, a.vx);
      simd::CountPairs const contacts(a.vy);
      Pack const normal = contacts.look_up_larger(share_normal);
      Pack const tangential = rotates ? contacts.look_up_larger(share_tangential) : normal;
      auto const contact = second_stage_contact<Law>(
          separation, fma(d.x, d.x, d.y * d.y), of.inverse_distance, change, normal, tangential);
      auto const add = [&](Force* to, PairForce<Pack> const& f) {
        scatter_damping(to, pairs, touching, f, rotates, of.inverse_distance);
      };
      add(Whole ? force + most_local : force,
          {separation, {}, law.dissipative_force(contact), {}, {}});
      if constexpr (Whole) {
        Pack spin = 0.0;
        if constexpr (rotates) spin = simd::load_sums(spins, pairs, of.ratio);
        auto const both = force_of_both_stages(law, repulsion, separation, contact,
                                               at_contact(d.vx, d.vy, spin), change);
        add(force, both);
        observe(PackOfPairs{pairs, touching, both});
      } else {
        ask();
      }
    }
  };
};

}  // namespace bagnold
