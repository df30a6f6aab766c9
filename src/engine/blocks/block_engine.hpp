// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>

#include "kernels/cpu/blocks/prune.hpp"
#include "kernels/cpu/blocks/wavefront.hpp"
#include "kernels/cpu/steps/dense_step.hpp"
#include "kernels/cpu/steps/two_stage_dense_step.hpp"
#include "kernels/physics/box/list_criterion.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "src/engine/clock.hpp"
#include "src/engine/contacts/contact_watch.hpp"
#include "src/engine/device_copy.hpp"
#include "src/engine/engine_memory.hpp"
#include "src/engine/failure.hpp"
#include "src/engine/in_box.hpp"
#include "src/engine/blocks/pruned_list.hpp"
#include "src/engine/simulation.hpp"
#include "src/engine/blocks/window_choice.hpp"
#include "src/engine/blocks/windowed_steps.hpp"

namespace bagnold {

/// How an engine goes from step to step.
enum class Stepping { automatic, dense, contact_rich, windowed };

/// A scheme on blocks of neighbouring disks, pairs and disks a pack at a time: step by step where
/// contacts are many, in windows where most disks fly free. Step: BlockStep or TwoStageBlockStep.
///
/// Blocks are cut by place and not by thread, and each adds up its own disks' forces, so the bits do
/// not depend on threads.
template <class Step>
class BlockEngine final : public Simulation {
 public:
  using Law = typename Step::Law;
  using Repulsion = typename Step::Repulsion;
  static constexpr bool rotates = Law::rotates;

  BlockEngine(std::unique_ptr<BlockLoop> loop, Stepping stepping, Law law, SpeciesTable table,
              double strain_rate, double time_step, double skin, Snapshot& snapshot)
      : loop_(std::move(loop)),
        stepping_(stepping),
        clock_{strain_rate, time_step, snapshot.state.box_length, snapshot.initial_offset,
               snapshot.initial_time},
        skin_(skin),
        step_(snapshot.step),
        builds_(snapshot.list_builds),
        diameter_(std::move(snapshot.state.diameter)) {
    kernels_.set_laws(law, table, time_step);
    auto motion = motions<rotates>(snapshot.state);
    std::vector<std::array<double, 2>>().swap(snapshot.state.velocity);
    std::vector<double>().swap(snapshot.state.spin);
    auto position = vectors(std::exchange(snapshot.state.position, {}));
    for_each_counter(RestoreCounter{snapshot.counters});
    if (snapshot.list_position.empty() || snapshot.memory.empty()) {  // another engine's: no blocks
      touching_ = count();  // not known yet: many
      build(std::move(position), std::move(motion));
      in_windows_ = stepping == Stepping::windowed;
    } else {
      list_step_ = snapshot.list_step;
      auto const listed = vectors(std::exchange(snapshot.list_position, {}));
      arrange(std::move(position), std::move(motion), &listed);
      fastest_ = fastest();
      for_each_memory(RestoreMemory{snapshot.memory});
      fill_inner();
    }
  }

  int columns() const override { return Sums<rotates>::columns; }
  std::int64_t step() const override { return step_; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    if (kernels_.trial.record.extent(0) == 0) take_scratch();
    for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;) {
      if (in_windows_)
        advance_window(sampling, windows);
      else
        advance_step(sampling, windows);
    }
  }

  Snapshot snapshot() const override {
    Snapshot s;
    s.state = raw_state();
    s.list_position.resize(count());
    for (std::size_t i = 0; i < count(); ++i) {
      auto const& r = at_build_(kernels_.blocks.slot_of(i));
      s.list_position[i] = {r.x, r.y};
    }
    s.list_step = list_step_;
    s.step = step_;
    s.initial_offset = clock_.initial_offset;
    s.initial_time = clock_.initial_time;
    s.list_builds = builds_;
    const_cast<BlockEngine*>(this)->for_each_memory(WriteDown{s.memory});
    const_cast<BlockEngine*>(this)->for_each_counter(WriteDown{s.counters});
    return s;
  }

  void give_back_scratch() override {
    kernels_.trial = {};
    for (auto& near : kernels_.blocks.near) near = {};
  }

  State state() const override { return in_box(raw_state()); }

 private:
  static constexpr bool two_stage = Step::scheme == Scheme::two_stage_leapfrog;
  static constexpr bool trial_spins = rotates && !two_stage;  ///< with two stages they are in the records
  static constexpr int looks = two_stage ? 1 : 2;  ///< at all near pairs, in a step
  using Dense = std::conditional_t<two_stage, TwoStageDenseStep<Law, Repulsion>, DenseStep<Law, Repulsion>>;
  using Force = typename Step::Force;
  using Window = typename WindowedSteps<Step>::Window;
  struct alignas(64) DenseScratch {
    std::byte bytes[sizeof(simd::Record) + sizeof(Force)];
  };

  std::size_t count() const { return diameter_.size(); }
  ShearedBox box_at(std::int64_t step) const {
    return {clock_.box_length, clock_.offset(step, list_step_), clock_.strain_rate};
  }

  /// What must be known to go on bit for bit, beside the state and the list.
  template <class Visit>
  void for_each_memory(Visit const& visit) {
    visit("fastest", fastest_);  // in dense steps a bound that depends on the steps before
    visit("outer_drift", outer_drift_);
    visit("prune_step", inner_.step);
    visit("inner_drift", inner_.drift);
    visit("inner_margin", inner_.margin);
    visit("near_pairs", near_pairs_);
    visit("touching", touching_);
    visit("dense", dense_);
    visit("in_windows", in_windows_);
    visit("window_allowance", windowed_.allowance);
    visit("window_usual_stray", windowed_.usual);
    visit("window_allowance_steps", allowance_steps_);
    choice_.for_each_memory(visit);
    windows_pay_.for_each_memory(visit);
  }

  /// What reports count; no bit depends on it.
  template <class Visit>
  void for_each_counter(Visit const& visit) {
    visit("pairs_evaluated", pairs_evaluated_);
    visit("prunings", prunings_);
    visit("steps_dense", steps_dense_);
    visit("steps_one_by_one", steps_one_by_one_);
    visit("windows", windowed_.counters.windows);
    visit("steps_in_windows", windowed_.counters.steps);
    visit("windows_refused", windows_refused_);
    visit("pairs_missed_and_added", windowed_.counters.again);
    visit("binary_islands", windowed_.counters.binary);
    visit("binary_steps", windowed_.counters.binary_steps);
    visit("disks_in_larger_islands", windowed_.counters.others);
    visit("touching_in_windows", windowed_.counters.touching);
  }

  void step_once(Sampling const& sampling, OpenWindows& windows) {
    keep_lists();
    bool const sampled = sampling.sampled(step_);
    if (windows.contacts) {  // they are looked for in all blocks, between the halves of the step
      first_half(0, kernels_.blocks.count);
      watch_.look(*loop_, kernels_, box_at(step_), step_, sampling, windows);
      second_half(0, kernels_.blocks.count, sampled);
    } else {
      Wavefront::Stage from{0, 0};
      for (auto const& to : wavefront_.stages) {
        first_half(from.first_half, to.first_half);
        second_half(from.second_half, to.second_half, sampled);
        from = to;
      }
    }
    if (sampled) windows.add(sampling.window(step_), sums().value, 1);
    count_step();
  }

  void advance_step(Sampling const& sampling, OpenWindows& windows) {
    step_once(sampling, windows);
    if (stepping_ != Stepping::automatic || step_ % look_every != 0) return;
    windows_pay_.steps_done(look_every, contacts_per_disk());
    in_windows_ = windows_pay_.enter();
  }

  /// Z, contacts across edges of blocks counted twice.
  Real contacts_per_disk() const {
    return 2 * static_cast<Real>(touching_) / static_cast<Real>(count());
  }

  /// Windows end at multiples of their length, so that it does not matter where a run is interrupted.
  void advance_window(Sampling const& sampling, OpenWindows& windows) {
    auto const length = choice_.steps();
    auto const end = std::min((step_ / length + 1) * length, sampling.last_step);
    windowed_.cautious = choice_.cautious();
    set_allowance(length);
    Window window{step_, end, list_step_, 0};
    Real farthest = farthest_at(end);
    window.most_stray = list_reach(clock_.strain_between(list_step_, end), skin_) - farthest;
    if (window.most_stray < 2 * windowed_.allowance && list_step_ != step_) {
      rebuild();
      farthest = farthest_at(end);
      window.list_step = list_step_;
      window.most_stray = list_reach(clock_.strain_between(list_step_, end), skin_) - farthest;
    }
    if (!windowed_.run(*loop_, kernels_, clock_, window, sampling, windows, watch_,
                       stepping_ == Stepping::windowed ? 1 : most_active))
      return step_through(window, sampling, windows);
    bool const whole = end - step_ == length;
    step_ = end;
    outer_drift_ = farthest + window.strayed;
    if (whole) {
      choice_.done(cost_of(window) / static_cast<Real>(length));
      weigh(window, 2 * window.contacts / static_cast<Real>(count()), 0);
    }
  }

  /// How far a disk may stray grows with the length of the window.
  void set_allowance(std::int64_t length) {
    if (windowed_.allowance == 0)
      windowed_.allowance = fastest() * clock_.time_step * static_cast<Real>(length) / 4;
    else if (length != allowance_steps_)
      windowed_.allowance *= static_cast<Real>(length) / static_cast<Real>(allowance_steps_);
    if (windowed_.usual == 0)
      windowed_.usual = windowed_.allowance / 4;
    else if (length != allowance_steps_)
      windowed_.usual *= static_cast<Real>(length) / static_cast<Real>(allowance_steps_);
    allowance_steps_ = length;
  }

  /// Steps through a window that cannot be done as one.
  void step_through(Window const& window, Sampling const& sampling, OpenWindows& windows) {
    ++windows_refused_;
    windowed_.allowance /= 2;
    fastest_ = fastest();
    outer_drift_ = farthest();
    prune();
    while (step_ < window.end) step_once(sampling, windows);
    if (!choice_.refused()) weigh(window, contacts_per_disk(), cost_one_by_one(contacts_per_disk()));
  }

  /// Whether windows go on, after one that was done (then `stepped_through` is 0), or was tried in vain
  /// and stepped through for so many cycles a disk-step.
  void weigh(Window const& window, Real contacts, Real stepped_through) {
    if (stepping_ != Stepping::automatic) return;
    auto const steps = static_cast<Real>(window.end - window.begin);
    in_windows_ = windows_pay_.window_done(steps, contacts, cost_of(window) + steps * stepped_through,
                                           steps * cost_one_by_one(contacts));
    if (in_windows_) return;
    fastest_ = fastest();
    prune();
  }

  /// [cycles a disk].
  Real cost_of(Window const& window) const {
    auto const disks = static_cast<Real>(count());
    return window.work.cost(static_cast<Real>(window.end - window.begin), disks,
                            static_cast<Real>(kernels_.blocks.outer.extent(0))) / disks;
  }

  /// [cycles a disk-step].
  static Real cost_one_by_one(Real contacts) {
    return Step::costs.by_itself + Step::costs.contact * contacts;
  }

  /// The first half of the step for some blocks, in the order of the wavefront: changes what is not seen
  /// from outside.
  void first_half(std::uint32_t begin, std::uint32_t end) {
    auto const box = box_at(step_);
    loop_->with_scratch<Force>(end - begin, kernels_.blocks.most_local, [&](std::uint32_t k, Force* force) {
      auto const b = wavefront_.first_half[begin + k];
      reports_(b) = dense_ ? dense_step_.predict(kernels_, b, box, force)
                           : kernels_.predict(b, box, force);
    });
  }

  /// The second half, and before it the sums of the configuration where the step began.
  void second_half(std::uint32_t begin, std::uint32_t end, bool sampled) {
    if (begin == end) return;
    auto const next_box = box_at(step_ + 1);
    auto const most_local = kernels_.blocks.most_local;
    std::size_t const room = most_local * std::size_t{Step::observed_forces};
    auto const of_block = [&](std::uint32_t k, Force* force, auto const& correct) {
      auto const b = wavefront_.second_half[begin + k];
      if (sampled) sums_(b) = measure_block(kernels_, b, clock_.strain_rate, force);
      reports_(b) += correct(b);
    };
    if (!dense_)
      loop_->with_scratch<Force>(end - begin, room, [&](std::uint32_t k, Force* force) {
        of_block(k, force, [&](std::uint32_t b) {
          return kernels_.correct(b, next_box, force, sampled, [](auto&&...) {});
        });
      });
    else
      loop_->with_scratch<DenseScratch>(end - begin, room, [&](std::uint32_t k, DenseScratch* scratch) {
        auto* const moved = reinterpret_cast<simd::Record*>(scratch);
        auto* const force = reinterpret_cast<Force*>(moved + most_local);
        of_block(k, force, [&](std::uint32_t b) {
          return dense_step_.correct(kernels_, b, next_box, force, sampled, moved);
        });
      });
  }

  void count_step() {
    ++step_;
    ++steps_one_by_one_;
    steps_dense_ += dense_;
    Real fastest2 = 0, overlap = 0, poison = 0;
    std::uint64_t touching = 0;
    for (std::uint32_t b = 0; b < kernels_.blocks.count; ++b) {
      fastest2 = std::max(fastest2, reports_(b).fastest2);
      overlap = std::max(overlap, reports_(b).largest_overlap);
      poison += reports_(b).poison;
      touching += reports_(b).touching;
    }
    touching_ = touching;
    if (poison != 0 || overlap > largest_relative_overlap) fail();
    Real const before = fastest_;
    fastest_ = std::sqrt(fastest2);
    if (dense_) fastest_ = std::max(fastest_, before * step_strain_factor());  // of those in flight
    // |dw| of a step; the second factor: the mean flow at the new place, not the old one.
    Real const moved = clock_.time_step * (before + fastest_) / 2 * step_strain_factor();
    outer_drift_ += moved;
    inner_.drift += moved;
    pairs_evaluated_ += looks * static_cast<std::int64_t>(near_pairs_);
  }

  Real step_strain_factor() const {
    return 1 + std::abs(clock_.strain_rate) * clock_.time_step;
  }

  /// Whether a list from `since` still holds for the next trial positions, if no disk has moved more
  /// than `drift` beyond the mean flow.
  bool holds_next(std::int64_t since, Real drift, Real skin) const {
    Real const strain = std::abs(clock_.strain_between(since, step_ + 1));
    if (strain > 0.5) return false;
    // drift adds up |v - gammadot y x^|; w is taken about the flow at the place of the build, which
    // differs by gammadot w_y.
    Real const w = (drift + clock_.time_step * fastest_ * step_strain_factor()) / (1 - strain);
    return list_holds(strain, w * w, skin);
  }

  /// Renews what would not hold through the next step.
  void keep_lists() {
    if (!holds_next(list_step_, outer_drift_, skin_)) {
      outer_drift_ = farthest();
      if (!holds_next(list_step_, 1.25 * outer_drift_, skin_)) {
        rebuild();
        if (!holds_next(list_step_, outer_drift_, skin_))
          failure::too_fast(clock_, step_, fastest_disk(), fastest_ * clock_.time_step, skin_);
      }
    }
    if (!holds_next(inner_.step, inner_.drift, inner_.margin)) prune();
  }

  void rebuild() {
    give_back_scratch();
    std::vector<Vec2<Real>> position(count());
    std::vector<Motion<rotates>> motion(count());
    for (std::size_t i = 0; i < count(); ++i) {
      auto const slot = kernels_.blocks.slot_of(i);
      auto const& r = kernels_.now.record(slot);
      position[i] = {r.x, r.y};
      motion[i].velocity = {r.vx, r.vy};
      if constexpr (rotates) motion[i].spin = kernels_.now.spin(slot);
    }
    build(std::move(position), std::move(motion));
  }

  /// Takes the disks into the box and lists their pairs anew.
  void build(std::vector<Vec2<Real>> position, std::vector<Motion<rotates>> motion) {
    list_step_ = step_;
    auto const box = box_at(step_);
    for (std::size_t i = 0; i < count(); ++i) wrap(box, position[i], motion[i].velocity.x);
    arrange(std::move(position), std::move(motion));
    ++builds_;
    outer_drift_ = 0;
    fastest_ = fastest();
    prune();
  }

  /// Blocks and lists of disks at `listed`, by default where they are now, filled with the disks as they
  /// are now; all in the order of the start.
  void arrange(std::vector<Vec2<Real>> position, std::vector<Motion<rotates>> motion,
               std::vector<Vec2<Real>> const* listed = nullptr) {
    auto const& at_build = listed != nullptr ? *listed : position;
    kernels_.blocks = {};  // all is in the arguments: room for the search
    kernels_.now = kernels_.trial = {};
    kernels_.species = {};
    at_build_ = {};
    auto const species = species_of(diameter_);
    kernels_.blocks =
        loop_->build(at_build, species, kernels_.table, box_at(list_step_), skin_, block_size(count()));
    auto const& blocks = kernels_.blocks;
    auto const slots = blocks.slots;
    kernels_.species = loop_->zeros<Species>("state::species", slots);
    kernels_.now.record = loop_->zeros<simd::Record>("state::record", slots);
    if constexpr (rotates) kernels_.now.spin = loop_->zeros<double>("state::spin", slots);
    at_build_ = loop_->zeros<Vec2<Real>>("neighbors::at_build", slots);
    for (std::size_t i = 0; i < count(); ++i) {
      auto const slot = blocks.slot_of(i);
      kernels_.species(slot) = species[i];
      kernels_.now.record(slot) = {position[i].x, position[i].y, motion[i].velocity.x,
                                   motion[i].velocity.y};
      at_build_(slot) = at_build[i];
      if constexpr (rotates) kernels_.now.spin(slot) = motion[i].spin;
    }
    std::vector<Vec2<Real>>().swap(position);
    std::vector<Motion<rotates>>().swap(motion);

    make_trial();
    reports_ = loop_->zeros<BlockReport>("dynamics::reports", blocks.count);
    sums_ = loop_->zeros<Sums<rotates>>("observables::block_sums", blocks.count);
    wavefront_ = Wavefront(blocks, at_build_, blocks_at_once());
    windowed_.rearranged();
    watch_.rearranged();
  }

  /// The trial state, and the slots in both states behind the own disks: at rest, far from everything and
  /// from each other.
  void make_trial() {
    auto const& blocks = kernels_.blocks;
    if constexpr (Step::lists_contacts) kernels_.blocks.make_room(contact_list, "dynamics::contacts");
    kernels_.trial.record = loop_->zeros<simd::Record>("dynamics::trial_record", blocks.slots);
    if constexpr (trial_spins) kernels_.trial.spin = loop_->zeros<double>("dynamics::trial_spin", blocks.slots);
    for (std::uint32_t b = 0; b < blocks.count; ++b) make_inert(blocks.block(b));
  }

  /// What give_back_scratch gave back.
  void take_scratch() {
    kernels_.blocks.make_room(inner_list, "blocks::inner");
    make_trial();
    fill_inner();
  }

  /// Of large blocks less is halo; of at least 32 no thread is long without one.
  static std::uint32_t block_size(std::size_t disks) {
    return static_cast<std::uint32_t>(std::clamp<std::size_t>(disks / 32, 1024, 3072));
  }

  /// A row of blocks, or what keeps the threads busy; all where they fit into cache.
  std::uint32_t blocks_at_once() const {
    auto const count = kernels_.blocks.count;
    if (!kernels_.blocks.beyond_cache()) return count;
    return std::max(static_cast<std::uint32_t>(std::sqrt(count)),
                    4 * static_cast<std::uint32_t>(loop_->threads()));
  }

  void make_inert(Block const& block) {
    for (auto i = block.own; i < block.padded; ++i) {
      auto const slot = block.first + i;
      Real const far = 1e3 * clock_.box_length * (i - block.own + 1);
      kernels_.now.record(slot) = kernels_.trial.record(slot) = {far, 0, 0, 0};
      kernels_.species(slot) = 0;
      if constexpr (rotates) kernels_.now.spin(slot) = 0;
      if constexpr (trial_spins) kernels_.trial.spin(slot) = 0;
      at_build_(slot) = {far, 0};
    }
  }

  /// Takes the inner list anew, and chooses between dense and contact-rich steps.
  void prune() {
    if (dense_) fastest_ = fastest();
    inner_.margin = best_margin(use_of_inner(), inner_.margin, skin_);
    inner_.step = step_;
    inner_.drift = 0;
    if (!holds_next(inner_.step, inner_.drift, inner_.margin)) inner_.margin = skin_;
    choose_dense();
    fill_inner();
    ++prunings_;
    near_pairs_ = 0;
    for (std::uint32_t b = 0; b < kernels_.blocks.count; ++b)
      for (auto const n : kernels_.blocks.block(b).near[inner_list]) near_pairs_ += n;
  }

  void choose_dense() {
    if (stepping_ == Stepping::automatic)
      dense_ = contacts_per_disk() < Step::costs.dense_below * (dense_ ? 1.2 : 1.0);
    else
      dense_ = stepping_ == Stepping::dense;
  }

  ListUse use_of_inner() const {
    ListUse use;
    for (std::uint32_t b = 0; b < kernels_.blocks.count; ++b) {
      Block const& block = kernels_.blocks.block(b);
      use.wider += block.pairs[pair_classes] - block.pairs[0];
    }
    use.kept = near_pairs_;
    use.wanted = touching_;
    use.per_step = 2 * clock_.time_step * fastest_;
    use.step_cost = 12.5 * looks;
    if (dense_) {  // a pair that does not touch costs less, and near pairs are few
      use.step_cost = 3 * looks;
      use.fewest_steps = 12;
    }
    return use;
  }

  void fill_inner() {
    auto& blocks = kernels_.blocks;
    auto const box = box_at(step_);
    (*loop_)(blocks.count, [&](std::uint32_t b) {
      Block& block = blocks.block(b);
      refresh_halo(blocks, block, kernels_.now, box);
      prune_block(blocks, block, inner_list, kernels_.now.record.data() + block.first,
                  inner_.margin);
    });
    watch_.relisted();
    if (dense_) dense_step_.resize(*loop_, kernels_);
  }

  /// Largest |w| at a later step if all disks fly straight until then, [d_s].
  Real farthest_at(std::int64_t step) {
    Real const duration = static_cast<Real>(step - step_) * clock_.time_step;
    Real const strain = clock_.strain_between(list_step_, step);
    far2_.assign(kernels_.blocks.count, 0);
    (*loop_)(kernels_.blocks.count, [&](std::uint32_t b) {
      Block const& block = kernels_.blocks.block(b);
      far2_[b] = farthest2_after(block, kernels_.now.record.data() + block.first,
                                 at_build_.data() + block.first, duration, strain);
    });
    return std::sqrt(*std::max_element(far2_.begin(), far2_.end()));
  }

  /// (v - gammadot y x^)^2 of a disk, [d_s^2 / tau_e^2].
  Real speed2(std::size_t disk) const {
    auto const& r = kernels_.now.record(kernels_.blocks.slot_of(disk));
    Real const ux = std::fma(-clock_.strain_rate, r.y, r.vx);
    return std::fma(ux, ux, r.vy * r.vy);
  }

  /// Largest |v - gammadot y x^|, [d_s / tau_e].
  Real fastest() const {
    Real fastest2 = 0;
    for (std::uint32_t b = 0; b < kernels_.blocks.count; ++b)
      fastest2 = std::max(fastest2, fastest2_of(kernels_.blocks.block(b), kernels_.now, clock_.strain_rate));
    return std::sqrt(fastest2);
  }

  std::size_t fastest_disk() const {
    std::size_t disk = 0;
    for (std::size_t i = 1; i < count(); ++i)
      if (speed2(i) > speed2(disk)) disk = i;
    return disk;
  }

  /// Largest |w| since the build, [d_s].
  Real farthest() const {
    Real const strain = clock_.strain_between(list_step_, step_);
    return std::sqrt(largest_of([&](std::size_t i) {
      auto const slot = kernels_.blocks.slot_of(i);
      auto const& r = kernels_.now.record(slot);
      return excursion2({r.x, r.y}, at_build_(slot), strain);
    }));
  }

  template <class Value>
  Real largest_of(Value const& value) const {
    Real largest = 0;
    for (std::size_t i = 0; i < count(); ++i) largest = std::max(largest, value(i));
    return largest;
  }

  Sums<rotates> sums() const {
    Sums<rotates> total;
    for (std::uint32_t b = 0; b < kernels_.blocks.count; ++b)
      for (int c = 0; c < columns(); ++c) total.value[c] += sums_(b).value[c];
    return total;
  }

  [[noreturn]] void fail() const {
    failure::check_finite(clock_, step_, raw_state());
    auto const [overlap, disk] = deepest();
    failure::too_deep(clock_, step_, disk, overlap);
  }

  /// The largest relative overlap that the forces were last worked out at, and a disk that has it.
  std::pair<Real, std::size_t> deepest() const {
    std::pair<Real, std::uint32_t> found{-1, 0};
    auto const& blocks = kernels_.blocks;
    auto const place = [&](std::uint32_t slot) -> Vec2<Real> {
      if constexpr (two_stage) {  // where the step began
        auto const& r = kernels_.now.record(slot);
        return {r.x - clock_.time_step * r.vx, r.y - clock_.time_step * r.vy};
      } else {
        auto const& r = kernels_.trial.record(slot);
        return {r.x, r.y};
      }
    };
    for (std::uint32_t b = 0; b < blocks.count; ++b) {
      Block const& block = blocks.block(b);
      if constexpr (two_stage) refresh_halo(blocks, block, kernels_.now, box_at(step_));
      for (int c = 0; c < pair_classes; ++c)
        for (std::uint32_t k = 0; k < block.near[inner_list][c]; ++k) {
          auto const pair = blocks.near[inner_list](block.pairs[c] + k);
          auto const p = place(block.first + pair.a()), q = place(block.first + pair.b());
          Real const overlap = 1 - std::hypot(p.x - q.x, p.y - q.y) / class_distance(c);
          if (overlap > found.first) found = {overlap, block.first + std::min(pair.a(), pair.b())};
        }
    }
    std::size_t disk = 0;
    while (disk + 1 < count() && blocks.slot_of(disk) != found.second) ++disk;
    return {found.first, disk};
  }

  State raw_state() const {
    State state;
    state.position.resize(count());
    state.velocity.resize(count());
    if constexpr (rotates) state.spin.resize(count());
    for (std::size_t i = 0; i < count(); ++i) {
      auto const slot = kernels_.blocks.slot_of(i);
      auto const& r = kernels_.now.record(slot);
      state.position[i] = {r.x, r.y};
      state.velocity[i] = {r.vx, r.vy};
      if constexpr (rotates) state.spin[i] = kernels_.now.spin(slot);
    }
    state.diameter = diameter_;
    state.box_length = clock_.box_length;
    state.offset = clock_.offset(step_, step_);
    state.time = clock_.time(step_);
    state.strain_rate = clock_.strain_rate;
    return state;
  }

  std::unique_ptr<BlockLoop> loop_;
  Stepping stepping_;
  Clock clock_;
  Real skin_;
  std::int64_t step_ = 0;
  std::int64_t list_step_ = 0;
  std::int64_t builds_ = 0;
  Real outer_drift_ = 0;  ///< at least the largest |w| since the build, [d_s]
  PrunedList inner_;
  std::uint64_t near_pairs_ = 0;  ///< in the inner list when it was pruned
  std::uint64_t touching_ = 0;    ///< pairs at the last step done by itself, those across edges twice
  bool dense_ = false;            ///< dense steps, until the next pruning
  Real fastest_ = 0;      ///< largest peculiar speed now, [d_s / tau_e]
  std::vector<double> diameter_;

  Step kernels_;
  Dense dense_step_;
  Wavefront wavefront_;
  Blocks::Array<Vec2<Real>> at_build_;
  Blocks::Array<BlockReport> reports_;
  Blocks::Array<Sums<rotates>> sums_;
  std::vector<Real> far2_;  ///< by block
  ContactWatch watch_;

  static constexpr std::int64_t look_every = 256;  ///< steps between choices
  static constexpr Real most_active = 0.6;  ///< share of the disks in a window
  WindowedSteps<Step> windowed_;
  bool in_windows_ = false;
  WindowChoice choice_;
  std::int64_t allowance_steps_ = 0;  ///< length of the windows that the allowance is for
  WindowsPay windows_pay_;
  std::int64_t steps_one_by_one_ = 0;
  std::int64_t windows_refused_ = 0;
  std::int64_t pairs_evaluated_ = 0;
  std::int64_t prunings_ = 0;
  std::int64_t steps_dense_ = 0;
};

}  // namespace bagnold
