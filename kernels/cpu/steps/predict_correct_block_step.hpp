// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/ask_ahead.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_forces.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "kernels/cpu/steps/kick.hpp"
#include "kernels/physics/schemes/forms.hpp"
#include "kernels/physics/schemes/second_stage.hpp"

namespace bagnold {

/// Step of a PredictCorrectScheme on a block, as in device/dynamics/predict_correct.hpp.
template <ContactLaw L, class R, PredictCorrectScheme S>
struct BlockStep<L, R, S> {
  using Law = L;
  using Repulsion = R;
  using Scheme = S;
  static constexpr bool rotates = Law::rotates;
  using Forces = BlockForces<Law, Repulsion>;
  using Force = typename Forces::Force;

  static constexpr StepCosts costs{.by_itself = 7, .contact = 39, .few_below = 0.3};
  static constexpr std::size_t scratch = sizeof(Force) + sizeof(simd::Record);

  Forces forces;
  Real time_step;  ///< dt, [tau_e]

  BlockStep(Law const& law, Repulsion const& repulsion, SpeciesTable const&, Real dt)
      : forces{law, repulsion}, time_step(dt) {}

  template <class Add>
  static void each_pass(Add const& add) {
    unsigned const spins = rotates ? +Uses::trial_spins : 0;
    add(&BlockStep::evaluate, {.awaits = Awaits::neighbours, .uses = Uses::near_pairs | spins});
    add(DrivePart::force);
    add(&BlockStep::predict);
    add(&BlockStep::measure_pairs, {.when = When::sampled});
    add(&BlockStep::measure_disks, {.when = When::sampled});
    add(DrivePart::power);
    add(&BlockStep::evaluate_trial, {.awaits = Awaits::neighbours, .uses = Uses::near_pairs});
    add(DrivePart::trial_force);
    add(&BlockStep::correct);
  }

  template <class Add>
  static void each_pass_for_few(Add const& add) {
    add(&BlockStep::predict_few, {Awaits::neighbours});
    add(&BlockStep::measure_pairs, {.when = When::sampled});
    add(&BlockStep::measure_disks, {.when = When::sampled});
    add(&BlockStep::correct_few, {Awaits::neighbours});
  }

  SecondStage const* second_stage() const { return nullptr; }

  /// Forces at t. force: scratch, [most_local].
  BlockReport evaluate(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                       Force* force) const {
    Block const& block = s.blocks.block(b);
    refresh_halo(s.blocks, block, s.now, at.box);
    bring_near(s.blocks, block, s.trial);
    auto const evaluate = [&](auto&& ask) {
      forces.evaluate(s, block, s.now, force, [&](PackOfPairs const&) { ask(); });
    };
    asking_ahead(s, b, at, evaluate, inner_list, s.now);
    return {};
  }

  /// First half: trial state at t + dt from forces at t.
  BlockReport predict(BlockSystem const& s, std::uint32_t b, StepAt const&, Force* force) const {
    Block const& block = s.blocks.block(b);
    Kick const kick(s.table, time_step);
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(s.now.record.data() + slot);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(s.species.data() + slot);
      predict(r, f, kick.per_mass(big));
      simd::store_records(s.trial.record.data() + slot, r);
      if constexpr (rotates)
        Scheme::trial_velocity(Pack::load(s.now.spin.data() + slot), f.torque_per_diameter,
                               kick.per_inertia(big))
            .store(s.trial.spin.data() + slot);
    }
    return {};
  }

  /// Forces at the trial state.
  BlockReport evaluate_trial(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                             Force* force) const {
    Block const& block = s.blocks.block(b);
    refresh_halo(s.blocks, block, s.trial, at.next_box);
    bring_near(s.blocks, block, s.now);
    OverlapBound overlaps;
    auto const evaluate = [&](auto&& ask) {
      forces.evaluate(s, block, s.trial, force, [&](PackOfPairs const& p) {
        overlaps(p);
        ask();
      });
    };
    asking_ahead(s, b, at, evaluate, inner_list, s.trial);
    return {.largest_overlap = simd::largest(overlaps.largest), .touching = overlaps.touching};
  }

  /// Second half: the state at t + dt from forces at the trial state.
  BlockReport correct(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    Block const& block = s.blocks.block(b);
    Kick const kick(s.table, time_step / 2);
    SpeedBound speeds{at.next_box.strain_rate};
    for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
      auto const slot = block.first + i;
      auto r = simd::load_records(s.now.record.data() + slot);
      auto const t = simd::load_records(s.trial.record.data() + slot);
      auto const f = simd::load_forces(force + i);
      auto const big = simd::nonzero(s.species.data() + slot);
      correct(r, t, f, kick.per_mass(big));
      simd::store_records(s.now.record.data() + slot, r);
      if constexpr (rotates) {
        auto* const spin = s.now.spin.data() + slot;
        auto const trial = Pack::load(s.trial.spin.data() + slot);
        Scheme::velocity(Pack::load(spin), trial, f.torque_per_diameter, kick.per_inertia(big))
            .store(spin);
      }
      speeds(r, r.y);
    }
    return {.fastest2 = simd::largest(speeds.fastest2), .nan_flag = simd::sum(speeds.nan_flag)};
  }

  /// First half where few of the near pairs touch.
  BlockReport predict_few(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                          Force* force) const {
    Block const& block = s.blocks.block(b);
    ActiveDisks const& active = *at.active;
    auto const* const now = s.now.record.data() + block.first;
    auto* const trial = s.trial.record.data() + block.first;
    refresh_halo(s.blocks, block, s.now, at.box);
    active.count(b) = 0;
    active.find(s.blocks, b, now, force);
    forces.add(s, block, contact_list, s.now, force, NoPackObserver{});
    simd::fly(trial, now, block.padded, time_step);
    if constexpr (rotates) std::copy_n(spins(s.now, block), block.padded, spins(s.trial, block));
    Kick const kick(s.table, time_step);
    active.each_pack(
        block, active.count(b), s.species.data(), [&](std::uint16_t const* index4, simd::Mask big) {
          auto r = simd::load_records(now, index4);
          auto const f = simd::load_forces(force, index4);
          predict(r, f, kick.per_mass(big));
          simd::store_records(trial, index4, r);
          if constexpr (rotates)
            simd::store(spins(s.trial, block), index4,
                        Scheme::trial_velocity(simd::load(spins(s.now, block), index4),
                                               f.torque_per_diameter, kick.per_inertia(big)));
        });
    return {};
  }

  /// Second half where few of the near pairs touch.
  BlockReport correct_few(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                          Force* force) const {
    Block const& block = s.blocks.block(b);
    ShearedBox const& box = at.next_box;
    ActiveDisks const& active = *at.active;
    auto* const moved = reinterpret_cast<simd::Record*>(force + s.blocks.most_local);
    auto* const now = s.now.record.data() + block.first;
    auto const* const trial = s.trial.record.data() + block.first;
    refresh_halo(s.blocks, block, s.trial, box);
    active.find(s.blocks, b, trial, force);
    OverlapBound overlaps;
    forces.add(s, block, contact_list, s.trial, force, overlaps);
    Kick const kick(s.table, time_step / 2);
    SpeedBound speeds{box.strain_rate};
    auto* to = moved;
    active.each_pack(
        block, active.count(b), s.species.data(), [&](std::uint16_t const* index4, simd::Mask big) {
          auto r = simd::load_records(now, index4);
          auto const f = simd::load_forces(force, index4);
          correct(r, simd::load_records(trial, index4), f, kick.per_mass(big));
          simd::store_records(to, r);
          to += simd::width;
          if constexpr (rotates) {
            auto* const spin = spins(s.now, block);
            auto const trial_spin = simd::load(spins(s.trial, block), index4);
            simd::store(spin, index4,
                        Scheme::velocity(simd::load(spin, index4), trial_spin,
                                         f.torque_per_diameter, kick.per_inertia(big)));
          }
          speeds(r, r.y);
        });
    simd::fly(now, now, block.padded, time_step);
    auto const* const list = active.list.data() + block.first;
    for (std::uint32_t k = 0; k < active.count(b); ++k) {
      simd::at(now, list[k]) = moved[k];
      active.is_active(block.first + list[k] / 4u) = 0;
    }
    return {simd::largest(speeds.fastest2), simd::largest(overlaps.largest), overlaps.touching,
            simd::sum(speeds.nan_flag)};
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

  /// Shows all pairs of the inner list to an observer, at their state between the two halves of a
  /// step. force: [most_local], out: all forces.
  template <class Observer>
  void observe(BlockSystem const& s, Block const& block, Force* force, Observer&& observer) const {
    forces.evaluate(s, block, s.now, force, observer);
  }

  /// Powers of a pack of disks from i on, after observe(). spin: of these disks.
  PackPower observed_power(BlockSystem const&, Block const&, Force const* force, std::uint32_t i,
                           simd::Mask big, simd::Records const&, simd::Pack spin, Real) const {
    PackPower power;
    if constexpr (rotates)
      power.torque = diameter_of(big) * simd::load_forces(force + i).torque_per_diameter * spin;
    return power;
  }

 private:
  using Pack = simd::Pack;

  BAGNOLD_INLINE void predict(simd::Records& r, simd::ForceComponents const& f, Pack k) const {
    auto const place = Scheme::trial_position(r.position(), r.velocity(), Pack(time_step));
    r = simd::make_records(place, Scheme::trial_velocity(r.velocity(), f.force(), k));
  }

  BAGNOLD_INLINE void correct(simd::Records& r, simd::Records const& trial,
                              simd::ForceComponents const& f, Pack k) const {
    auto const after = Scheme::velocity(r.velocity(), trial.velocity(), f.force(), k);
    auto const place = Scheme::position(r.position(), r.velocity(), after, Pack(time_step / 2));
    r = simd::make_records(place, after);
  }

  static double* spins(BlockState const& state, Block const& block) {
    return state.spin.data() + block.first;
  }
};

}  // namespace bagnold
