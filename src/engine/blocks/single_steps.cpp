// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/single_steps.hpp"

#include <algorithm>
#include <cmath>

#include "src/engine/drive_columns.hpp"
#include "src/engine/failure.hpp"

namespace bagnold {

void SingleSteps::advance(Sampling const& sampling, OpenWindows& windows) {
  keep_lists();
  make_room();
  auto const step = disks_.system.step;
  bool const sampled = sampling.sampled(step);
  StepAt at{.box = disks_.box_at(step), .next_box = disks_.box_at(step + 1)};
  at.active = &active_;
  if (sampled) {
    at.sums = sums_.data();
    at.drive_powers = drive_powers_.data();
  }
  auto const& rounds = rounds_[few][sampled];
  auto const count = disks_.system.blocks.count;
  for (std::size_t k = 0; k < rounds.size(); ++k) {
    bool const first = k == 0, last = k + 1 == rounds.size();
    if (last && windows.contacts)
      detector_.detect(*disks_.loop, disks_.system, at.box, step, sampling, windows);
    if (!last && rounds[k + 1].awaits == Awaits::neighbours &&
        !(windows.contacts && k + 2 == rounds.size())) {
      go_through_both(rounds[k], rounds[k + 1], at);
      ++k;
    } else {
      go_through(rounds[k],
                 first  ? Route{&lists_.wavefront().first_half, first_half_of_step}
                 : last ? Route{&lists_.wavefront().second_half, second_half_of_step}
                        : Route{},
                 0, count, at);
    }
  }
  if (sampled) {
    add_up();
    windows.add(sampling.window(step), columns_, 1);
  }
  count_step();
}

/// Renews lists that would not be valid through the next step.
void SingleSteps::keep_lists() {
  if (!lists_.outer_holds(lists_.outer_nonaffine_bound)) {
    lists_.outer_nonaffine_bound = lists_.farthest();
    if (!lists_.outer_holds(1.25 * lists_.outer_nonaffine_bound)) {
      rebuild();
      if (!lists_.outer_holds(lists_.outer_nonaffine_bound))
        failure::too_fast(disks_.clock, disks_.system.step, disks_.fastest_disk(),
                          lists_.fastest * disks_.clock.time_step, lists_.skin());
    }
  }
  if (!lists_.inner_holds()) prune();
}

void SingleSteps::rebuild() {
  lists_.give_back_scratch();
  lists_.build(disks_.disks());
  prune();
}

void SingleSteps::prune() {
  if (few) lists_.fastest = disks_.fastest();
  auto const use = use_of_inner();
  if (stepping_ == Stepping::automatic)
    few = contacts_per_disk() < disks_.stepper->costs.few_below * (few ? 1.2 : 1.0);
  else
    few = stepping_ == Stepping::few_contacts;
  lists_.prune(use);
  ++counters.prunings;
}

ListUse SingleSteps::use_of_inner() const {
  ListUse use;
  use.wanted = touching;
  use.step_cost = 12.5 * evaluations_;
  if (few) {  // a pair that does not touch costs less, and near pairs are few
    use.step_cost = 3 * evaluations_;
    use.fewest_steps = 12;
  }
  return use;
}

/// Allocates arrays for new blocks, and lists the disks that touch in a new inner list.
void SingleSteps::make_room() {
  auto& system = disks_.system;
  auto& loop = *disks_.loop;
  if (arrangement_ != system.arrangement) {
    reports_ = loop.zeros<BlockReport>("dynamics::reports", system.blocks.count);
    sums_ = loop.zeros<BlockSums>("observables::block_sums", system.blocks.count);
    if (disks_.stepper->uses(Uses::drive)) make_room_for_drive();
    arrangement_ = system.arrangement;
  }
  if (!few || listing_ == system.listing) return;
  active_.resize(loop, system.blocks);
  if (disks_.stepper->uses(Uses::changes))  // of which nothing has changed yet
    loop(system.blocks.count, [&](std::uint32_t b) {
      Block const& block = system.blocks.block(b);
      active_.count(b) = 0;
      std::fill_n(system.trial.record.data() + block.first, block.padded, simd::Record{});
    });
  listing_ = system.listing;
}

SingleSteps::Rounds SingleSteps::rounds_of(BlockPasses const& passes, bool sampled) {
  Rounds rounds;
  for (int k = 0; k < static_cast<int>(passes.size()); ++k) {
    if (!passes[k]->belongs(sampled)) continue;
    auto const awaits = passes[k]->facts.awaits;
    if (awaits != Awaits::own) rounds.push_back({awaits, k, k});
    rounds.back().end = k + 1;
  }
  return rounds;
}

/// Two rounds in one way through memory: the second one follows behind the first.
void SingleSteps::go_through_both(Round const& first, Round const& second, StepAt const& at) {
  auto const& wavefront = lists_.wavefront();
  Wavefront::Stage from{0, 0};
  for (auto const& to : wavefront.stages) {
    go_through(first, {&wavefront.first_half, first_half_of_step}, from.first_half, to.first_half,
               at);
    go_through(second, {&wavefront.second_half, second_half_of_step}, from.second_half,
               to.second_half, at);
    from = to;
  }
}

/// A round through some blocks, by their place on a route.
void SingleSteps::go_through(Round const& round, Route const& route, std::uint32_t begin,
                             std::uint32_t end, StepAt at) {
  if (begin == end) return;
  auto const& system = disks_.system;
  auto const& passes = few ? disks_.stepper->few : disks_.stepper->many;
  if (route.order != nullptr && system.blocks.beyond_cache())
    at.next = system.blocks.next[route.half].data();
  if (round.awaits == Awaits::all)
    for (std::uint32_t b = 0; b < system.blocks.count; ++b) at.total += reports_(b);
  auto const room = system.blocks.most_local * disks_.stepper->scratch;
  disks_.loop->with_scratch<std::byte>(end - begin, room, [&](std::uint32_t k, std::byte* scratch) {
    auto const b = route.order != nullptr ? (*route.order)[begin + k] : begin + k;
    auto here = at;
    auto& report = reports_(b);
    if (round.begin == 0) report = {};
    for (here.pass = round.begin; here.pass < round.end; ++here.pass) {
      auto const& pass = *passes[here.pass];
      if (pass.belongs(at.sums != nullptr)) report += pass.run(system, b, here, scratch);
    }
  });
}

void SingleSteps::count_step() {
  ++disks_.system.step;
  ++counters.steps;
  counters.few_contacts += few;
  BlockReport total;
  std::uint64_t pairs = 0;
  for (std::uint32_t b = 0; b < disks_.system.blocks.count; ++b) {
    pairs += reports_(b).touching;
    total += reports_(b);
  }
  touching = pairs;
  if (total.nan_flag != 0 || total.largest_overlap > largest_relative_overlap) disks_.fail();
  Real const before = lists_.fastest;
  lists_.fastest = std::sqrt(total.fastest2);
  if (few)  // of those in flight
    lists_.fastest = std::max(lists_.fastest, before * lists_.step_strain_factor());
  // |dw| of a step; the last factor accounts for the mean flow at the new place.
  Real const moved =
      disks_.clock.time_step * (before + lists_.fastest) / 2 * lists_.step_strain_factor();
  lists_.outer_nonaffine_bound += moved;
  lists_.inner.nonaffine_bound += moved;
  counters.pairs_evaluated += evaluations_ * static_cast<std::int64_t>(lists_.near_pairs);
}

/// Allocates powers of the drive, and the disk of each slot.
void SingleSteps::make_room_for_drive() {
  auto& system = disks_.system;
  drive_powers_ = disks_.loop->zeros<DrivePower>("observables::drive_powers", system.blocks.count);
  system.disk_of = disks_.loop->zeros<std::uint32_t>("dynamics::disk_of", system.blocks.slots);
  for (std::uint32_t i = 0; i < disks_.count(); ++i) system.disk_of(system.blocks.slot_of(i)) = i;
}

/// Columns of the configuration that was measured.
void SingleSteps::add_up() {
  auto const count = disks_.system.blocks.count;
  BlockSums total;
  for (std::uint32_t b = 0; b < count; ++b) total += sums_(b);
  auto const sums = disks_.columns_of(total);
  columns_.assign(sums.begin(), sums.end());
  if (drive_powers_.extent(0) == 0) return;
  DrivePower power;
  for (std::uint32_t b = 0; b < count; ++b) power += drive_powers_(b);
  append(columns_, power);
}

}  // namespace bagnold
