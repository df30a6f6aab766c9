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
  bool const iterates = disks_.stepper->needs.terms > 0;
  if (windows.contacts || iterates) {  // in all blocks, between the halves of the step
    auto const count = disks_.system.blocks.count;
    first_half(0, count);
    if (iterates) iterate(sampled);
    if (windows.contacts)
      detector_.detect(*disks_.loop, disks_.system, disks_.box_at(step), step, sampling, windows);
    second_half(0, count, sampled);
  } else {
    Wavefront::Stage from{0, 0};
    for (auto const& to : lists_.wavefront().stages) {
      first_half(from.first_half, to.first_half);
      second_half(from.second_half, to.second_half, sampled);
      from = to;
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
    few = contacts_per_disk() < disks_.stepper->needs.costs.few_below * (few ? 1.2 : 1.0);
  else
    few = stepping_ == Stepping::few_contacts;
  lists_.prune(use);
  ++counters.prunings;
}

ListUse SingleSteps::use_of_inner() const {
  int const evaluations = disks_.stepper->needs.evaluations;
  ListUse use;
  use.wanted = touching;
  use.step_cost = 12.5 * evaluations;
  if (few) {  // a pair that does not touch costs less, and near pairs are few
    use.step_cost = 3 * evaluations;
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
    if (disks_.stepper->needs.driven) make_room_for_drive();
    arrangement_ = system.arrangement;
  }
  if (!few || listing_ == system.listing) return;
  active_.resize(loop, system.blocks);
  if (disks_.stepper->needs.trial_is_change)  // of which nothing has changed yet
    loop(system.blocks.count, [&](std::uint32_t b) {
      Block const& block = system.blocks.block(b);
      active_.count(b) = 0;
      std::fill_n(system.trial.record.data() + block.first, block.padded, simd::Record{});
    });
  listing_ = system.listing;
}

/// First half of the step for some blocks, in the order of the wavefront. It changes nothing that
/// is visible outside.
void SingleSteps::first_half(std::uint32_t begin, std::uint32_t end) {
  auto const& system = disks_.system;
  auto const& stepper = *disks_.stepper;
  auto const box = disks_.box_at(disks_.system.step);
  auto const room = system.blocks.most_local * stepper.needs.force_bytes;
  disks_.loop->with_scratch<std::byte>(end - begin, room, [&](std::uint32_t k, std::byte* force) {
    auto const b = lists_.wavefront().first_half[begin + k];
    reports_(b) = few ? stepper.predict_few(system, active_, b, box, force)
                      : stepper.predict(system, b, box, force);
  });
}

/// Iterations of the scheme. The last one belongs to the second half, unless the step is sampled.
void SingleSteps::iterate(bool sampled) {
  auto& system = disks_.system;
  auto const& stepper = *disks_.stepper;
  BlockReport total;
  for (std::uint32_t b = 0; b < system.blocks.count; ++b) total += reports_(b);
  system.implicit.iterations = {total.coupling, stepper.needs.terms};
  auto const room = system.blocks.most_local * stepper.needs.force_bytes;
  for (int k = 0; k < system.implicit.passes() - (sampled ? 0 : 1); ++k)
    disks_.loop->with_scratch<std::byte>(
        system.blocks.count, room,
        [&](std::uint32_t b, std::byte* force) { stepper.iterate(system, b, k, force); });
}

/// Second half, and before it the sums of the configuration at which the step began.
void SingleSteps::second_half(std::uint32_t begin, std::uint32_t end, bool sampled) {
  if (begin == end) return;
  auto const& system = disks_.system;
  auto const& stepper = *disks_.stepper;
  auto const box = disks_.box_at(disks_.system.step + 1);
  auto const rate = disks_.clock.strain_rate;
  std::size_t const most = system.blocks.most_local;
  std::size_t const moved = few ? most * sizeof(simd::Record) : 0;
  auto const room =
      most * static_cast<std::size_t>(stepper.needs.observed_forces) * stepper.needs.force_bytes;
  disks_.loop->with_scratch<std::byte>(
      end - begin, moved + room, [&](std::uint32_t k, std::byte* scratch) {
        auto const b = lists_.wavefront().second_half[begin + k];
        auto* const force = scratch + moved;
        if (sampled) sums_(b) = stepper.measure(system, b, rate, force);
        if (sampled && stepper.needs.driven)
          drive_powers_(b) = stepper.drive_power(system, b, rate, force);
        reports_(b) += few ? stepper.correct_few(system, active_, b, box, force, sampled,
                                                 reinterpret_cast<simd::Record*>(scratch))
                           : stepper.correct(system, b, box, force, sampled, nullptr);
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
  counters.pairs_evaluated +=
      disks_.stepper->needs.evaluations * static_cast<std::int64_t>(lists_.near_pairs);
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
  if (!disks_.stepper->needs.driven) return;
  DrivePower power;
  for (std::uint32_t b = 0; b < count; ++b) power += drive_powers_(b);
  append(columns_, power);
}

}  // namespace bagnold
