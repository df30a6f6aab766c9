// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/block_engine.hpp"

#include <algorithm>
#include <utility>

#include "src/engine/device_copy.hpp"
#include "src/engine/engine_memory.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

namespace {

constexpr std::int64_t choose_every = 256;  ///< steps between choices
constexpr Real most_active = 0.6;           ///< share of the disks in a lookahead

}  // namespace

BlockEngine::BlockEngine(std::unique_ptr<BlockLoop> loop, std::unique_ptr<BlockStepper> stepper,
                         Stepping stepping, EngineInput const& input, Snapshot& snapshot)
    : stepping_(stepping),
      disks_{.loop = std::move(loop),
             .stepper = std::move(stepper),
             .clock = {input.rates, input.time_step, snapshot},
             .list = {},
             .diameter = std::move(snapshot.state.diameter),
             .system = {}},
      lists_(disks_, input.skin),
      single_(disks_, lists_, detector_, stepping),
      lookahead_(disks_, detector_, input.skin) {
  disks_.system.step = snapshot.step;
  disks_.system.table = input.species;
  disks_.system.rotates = input.rotates;
  lists_.builds = snapshot.list_builds;
  auto list = take_disks(snapshot.state);
  for_each_counter(RestoreCounter{snapshot.counters});
  if (snapshot.list_position.empty() || snapshot.memory.empty()) {  // another engine's: no blocks
    single_.touching = disks_.count();                              // not known yet: many
    lists_.build(std::move(list));
    single_.prune();
    looking_ahead_ = stepping == Stepping::lookahead;
  } else {
    disks_.list = disks_.clock.at(snapshot.list_step).mark(snapshot.list_step);
    auto const listed = vectors(std::exchange(snapshot.list_position, {}));
    lists_.arrange(std::move(list), &listed);
    for_each_memory(RestoreMemory{snapshot.memory});
    auto& pruned = lists_.inner.mark;
    pruned = disks_.clock.at(pruned.step).mark(pruned.step);
    lists_.fill_inner();
  }
}

void BlockEngine::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  if (disks_.system.trial.record.extent(0) == 0) lists_.take_scratch();
  for (auto const end = std::min(disks_.system.step + steps, sampling.last_step);
       disks_.system.step < end;) {
    if (looking_ahead_ && sampling.whole && lookahead_end() > sampling.last_step) return;
    if (looking_ahead_)
      advance_lookahead(sampling, windows);
    else
      advance_step(sampling, windows);
  }
}

Snapshot BlockEngine::snapshot() const {
  Snapshot s = disks_.clock.snapshot(disks_.system.step, disks_.list.step, lists_.builds);
  s.state = disks_.state();
  s.list_position = lists_.at_build();
  auto& self = const_cast<BlockEngine&>(*this);  // saving changes nothing
  self.for_each_memory(WriteDown{s.memory});
  self.for_each_counter(WriteDown{s.counters});
  return s;
}

State BlockEngine::state() const { return wrap_state(disks_.state()); }

/// Visits the numbers that a bit-for-bit restart needs besides the state and the list.
template <class Visit>
void BlockEngine::for_each_memory(Visit const& visit) {
  visit("fastest", lists_.fastest);  // with few contacts a bound that depends on the steps before
  visit("outer_nonaffine_bound", lists_.outer_nonaffine_bound);
  visit("prune_step", lists_.inner.mark.step);
  visit("inner_nonaffine_bound", lists_.inner.nonaffine_bound);
  visit("inner_margin", lists_.inner.margin);
  visit("near_pairs", lists_.near_pairs);
  visit("touching", single_.touching);
  visit("few_contacts", single_.few);
  visit("looking_ahead", looking_ahead_);
  visit("lookahead_allowance", lookahead_.allowance);
  visit("lookahead_usual_deviation", lookahead_.usual);
  visit("lookahead_allowance_steps", allowance_steps_);
  tuning_.for_each_memory(visit);
  gain_.for_each_memory(visit);
}

/// Visits the counters of the report; no bit depends on them.
template <class Visit>
void BlockEngine::for_each_counter(Visit const& visit) {
  visit("pairs_evaluated", single_.counters.pairs_evaluated);
  visit("prunings", single_.counters.prunings);
  visit("steps_few_contacts", single_.counters.few_contacts);
  visit("steps_one_by_one", single_.counters.steps);
  visit("lookaheads", lookahead_.counters.lookaheads);
  visit("lookahead_steps", lookahead_.counters.steps);
  visit("lookaheads_refused", lookaheads_refused_);
  visit("pairs_missed_and_added", lookahead_.counters.again);
  visit("binary_islands", lookahead_.counters.binary);
  visit("binary_steps", lookahead_.counters.binary_steps);
  visit("disks_in_larger_islands", lookahead_.counters.others);
  visit("touching_in_lookahead", lookahead_.counters.touching);
}

/// One step, and the change of the strain rate where it ends.
void BlockEngine::advance_one(Sampling const& sampling, OpenWindows& windows) {
  single_.advance(sampling, windows);
  if (disks_.system.step == disks_.clock.rate_end) follow(disks_.clock.change_rate());
}

/// Changes all motions where the clock has gone on to another strain rate.
void BlockEngine::follow(RateChange const& change) {
  disks_.change_motions(change);
  Real const rate = disks_.clock.strain_rate,
             before = change.factor == 1 ? rate - change.rise : rate;
  bool const goes_on = before * rate > 0;
  if (goes_on)
    lists_.fastest = disks_.fastest();
  else  // bounds of motions hold for shear of one sign
    single_.rebuild();
}

void BlockEngine::begin_piece(double strain_rate, double scale) {
  if (scale != 1) {
    DiskList list = disks_.disks();
    Real const rise =
        disks_.clock.strain_rate * (scale - 1);  // of the mean flow at a disk, by its y
    for (std::size_t i = 0; i < disks_.count(); ++i) {
      list.velocity[i].x += rise * list.position[i].y;
      list.position[i] = scale * list.position[i];
    }
    disks_.clock.scale_box(scale);
    lists_.give_back_scratch();
    lists_.build(std::move(list));
    single_.prune();
  }
  if (strain_rate != disks_.clock.strain_rate)
    follow(disks_.clock.begin_piece(disks_.system.step, strain_rate, disks_.list.step));
}

void BlockEngine::advance_step(Sampling const& sampling, OpenWindows& windows) {
  advance_one(sampling, windows);
  if (stepping_ != Stepping::automatic || disks_.system.step % choose_every != 0) return;
  gain_.steps_done(choose_every, single_.contacts_per_disk());
  looking_ahead_ = gain_.enter();
}

/// End of a lookahead: a multiple of its length, so that interruptions of a run change no bit.
std::int64_t BlockEngine::lookahead_end() const {
  auto const length = tuning_.steps();
  return (disks_.system.step / length + 1) * length;
}

void BlockEngine::advance_lookahead(Sampling const& sampling, OpenWindows& windows) {
  auto const length = tuning_.steps();
  auto const begin = disks_.system.step;
  auto const end = std::min(lookahead_end(), sampling.last_step);
  lookahead_.cautious = tuning_.cautious();
  set_allowance(length);
  Real const duration = lookahead_.time_flights(end);
  Clock const after = end < disks_.clock.rate_end ? disks_.clock : disks_.clock.at(end);
  Real farthest = lists_.farthest_at(end, after, duration);
  Lookahead lookahead{begin, end, after, lists_.room_at(end, after, farthest)};
  if (lookahead.most_deviation < 2 * lookahead_.allowance && disks_.list.step != begin) {
    single_.rebuild();
    farthest = lists_.farthest_at(end, after, duration);
    lookahead.most_deviation = lists_.room_at(end, after, farthest);
  }
  if (!lookahead_.run(lookahead, sampling, windows,
                      stepping_ == Stepping::lookahead ? 1 : most_active))
    return step_through(lookahead, sampling, windows);
  disks_.system.step = end;
  if (end >= disks_.clock.rate_end) disks_.clock.move_to(end);
  lists_.outer_nonaffine_bound = farthest + lookahead.deviation;
  if (lookahead.steps() != length) return;
  tuning_.done(cost_of(lookahead) / static_cast<Real>(length));
  weigh(lookahead, 2 * lookahead.contacts / static_cast<Real>(disks_.count()), 0);
}

/// Sets the allowance for deviations of a disk, which grows with the length of the lookahead.
void BlockEngine::set_allowance(std::int64_t length) {
  Real const longer = static_cast<Real>(length) / static_cast<Real>(allowance_steps_);
  if (lookahead_.allowance == 0)
    lookahead_.allowance =
        disks_.fastest() * disks_.clock.time_step * static_cast<Real>(length) / 4;
  else if (length != allowance_steps_)
    lookahead_.allowance *= longer;
  if (lookahead_.usual == 0)
    lookahead_.usual = lookahead_.allowance / 4;
  else if (length != allowance_steps_)
    lookahead_.usual *= longer;
  allowance_steps_ = length;
}

/// Does the steps of a lookahead that failed one by one.
void BlockEngine::step_through(Lookahead const& lookahead, Sampling const& sampling,
                               OpenWindows& windows) {
  ++lookaheads_refused_;
  lookahead_.allowance /= 2;
  lists_.fastest = disks_.fastest();
  lists_.outer_nonaffine_bound = lists_.farthest();
  single_.prune();
  while (disks_.system.step < lookahead.end) advance_one(sampling, windows);
  auto const contacts = single_.contacts_per_disk();
  if (!tuning_.refused()) weigh(lookahead, contacts, single_.cost(contacts));
}

/// Decides whether lookaheads continue after one more. `stepped_through`: 0 if the lookahead was
/// completed; if it failed, the cost of the ordinary steps that replaced it, [cycles a disk-step].
void BlockEngine::weigh(Lookahead const& lookahead, Real contacts, Real stepped_through) {
  if (stepping_ != Stepping::automatic) return;
  auto const steps = static_cast<Real>(lookahead.steps());
  looking_ahead_ =
      gain_.lookahead_done(steps, contacts, cost_of(lookahead) + steps * stepped_through,
                           steps * single_.cost(contacts));
  if (looking_ahead_) return;
  lists_.fastest = disks_.fastest();
  single_.prune();
}

/// Cost of a lookahead, [cycles a disk].
Real BlockEngine::cost_of(Lookahead const& lookahead) const {
  auto const disks = static_cast<Real>(disks_.count());
  return lookahead.work.cost(static_cast<Real>(lookahead.steps()), disks,
                             static_cast<Real>(disks_.system.blocks.outer.extent(0))) /
         disks;
}

}  // namespace bagnold
