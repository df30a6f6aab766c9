// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/lookahead_steps.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold {

bool LookaheadSteps::run(Lookahead& lookahead, Sampling const& sampling, OpenWindows& windows,
                         Real most_active) {
  auto& results = scratch_.results;
  for (auto const& disk : results.disks) in_batch_[disk.slot] = 0;
  results.forget();
  if (lookahead.most_deviation < 0) return false;
  make_room();
  list_samples(lookahead, sampling);
  Real const duration = scratch_.flights.time(lookahead.steps());
  scratch_.start = disks_.box_at(lookahead.begin);
  scratch_.contacts.begin(detector_, disks_.system, scratch_.start, lookahead.begin, sampling,
                          windows);
  list_.renew(lookahead, scratch_.start, duration, allowance);
  predict(duration);
  Real const most = most_active * static_cast<Real>(disks_.count());
  while (!todo_.empty()) {
    finder_.find(todo_, islands_);
    if (!islands_.unfolds) return false;
    sort_islands();
    auto const active =
        lookahead.work.others + static_cast<Real>(batch_islands_.islands.disks.size());
    if (active > most) return false;
    if (!pair_islands_.run(disks_, islands_, lookahead, scratch_)) return false;
    if (!batch_islands_.run(disks_, lookahead, scratch_)) return false;
    lookahead.deviation = results.largest_deviation();
    if (lookahead.deviation > lookahead.most_deviation) return false;
    find_missed(duration);
  }
  measure(lookahead, sampling, windows);
  if (scratch_.contacts)
    scratch_.contacts.tell(lookahead.end, scratch_.times, sampling, windows,
                           [&](std::size_t unit) { return results.units[unit].alive; });
  commit(lookahead.after.box(lookahead.end, disks_.list), lookahead.steps());
  adapt_allowance();
  count(lookahead);
  return true;
}

/// Allocates arrays by slot, which runs without lookaheads do not need.
void LookaheadSteps::make_room() {
  if (arrangement_ == disks_.system.arrangement) return;
  auto const slots = disks_.system.blocks.slots;
  finder_.resize(slots);
  scratch_.results.disk_of.assign(slots, MeetingResults::none);
  in_batch_.assign(slots, 0);
  arrangement_ = disks_.system.arrangement;
}

Real LookaheadSteps::time_flights(std::int64_t end) {
  auto const& clock = disks_.clock;
  auto& flights = scratch_.flights;
  flights.clear(clock.time_step);
  if (clock.rate_end <= end)
    for (auto step = disks_.system.step; step <= end;) {
      auto const stretch = clock.rates.at(step);
      Real const scale = stretch.rate / clock.strain_rate;
      for (; step <= end && step < stretch.end; ++step) flights.add(scale);
    }
  return flights.time(end - disks_.system.step);
}

void LookaheadSteps::list_samples(Lookahead const& lookahead, Sampling const& sampling) {
  scratch_.times.clear();
  auto const first = sampling.window(lookahead.begin);
  for (auto s = sampling.next(lookahead.begin); s < lookahead.end; s = sampling.next(s + 1))
    scratch_.times.add(s - lookahead.begin, static_cast<std::size_t>(sampling.window(s) - first),
                       scratch_.flights);
}

void LookaheadSteps::predict(Real duration) {
  auto const& all = disks_.system;
  forecast_.resize(all.blocks.count);
  (*disks_.loop)(all.blocks.count, [&](std::uint32_t b) {
    Block const& block = all.blocks.block(b);
    forecast_[b].clear();
    refresh_halo(all.blocks, block, all.now, scratch_.start);
    predict_contacts(all.blocks, block, list_.of(block), all.now.record.data() + block.first,
                     duration, allowance, usual, forecast_[b]);
  });
  todo_.clear();
  for (auto const& of_block : forecast_)
    todo_.insert(todo_.end(), of_block.meeting.begin(), of_block.meeting.end());
  if (cautious) add_near();
}

/// Adds the near pairs of disks that meet another.
void LookaheadSteps::add_near() {
  std::vector<std::uint32_t> meeting;
  auto& meets = in_batch_;  // not in use yet
  auto const mark = [&](std::uint32_t slot) {
    meets[slot] = 1;
    meeting.push_back(slot);
  };
  for (auto const& pair : todo_) {
    mark(pair.a);
    mark(pair.b.index());
  }
  for (auto const& of_block : forecast_)
    for (auto const& [pair, deviating] : of_block.near)
      if (meets[pair.a] + meets[pair.b.index()] >= deviating) todo_.push_back(pair);
  for (auto const slot : meeting) meets[slot] = 0;
}

/// Separates islands of two disks from larger ones.
void LookaheadSteps::sort_islands() {
  auto& larger = batch_islands_.islands;
  pair_islands_.pairs.clear();
  larger.disks.clear();
  larger.pairs.clear();
  larger.first_disk.assign(1, 0);
  larger.first_pair.assign(1, 0);
  for (std::size_t i = 0; i < islands_.count(); ++i) {
    auto const disk = islands_.first_disk[i], end_disk = islands_.first_disk[i + 1];
    auto const pair = islands_.first_pair[i], end_pair = islands_.first_pair[i + 1];
    if (end_disk - disk == 2 && end_pair - pair == 1) {
      pair_islands_.pairs.push_back(islands_.pairs[pair]);
      continue;
    }
    auto const shift = static_cast<std::uint32_t>(larger.disks.size()) - disk;  // modulo 2^32
    larger.disks.insert(larger.disks.end(), islands_.disks.begin() + disk,
                        islands_.disks.begin() + end_disk);
    for (auto p = pair; p < end_pair; ++p)
      larger.pairs.push_back({islands_.pairs[p].a + shift, islands_.pairs[p].b + shift});
    larger.first_disk.push_back(static_cast<std::uint32_t>(larger.disks.size()));
    larger.first_pair.push_back(static_cast<std::uint32_t>(larger.pairs.size()));
  }
}

/// Fills todo_ with the pairs that were not predicted and could have touched, by the deviations
/// measured, and with all pairs of the units of their disks.
void LookaheadSteps::find_missed(Real duration) {
  auto const& results = scratch_.results;
  auto const& blocks = disks_.system.blocks;
  todo_.clear();
  for (auto const& of_block : forecast_)
    for (auto const& near : of_block.near)
      if (results.has(near.pair.a) || results.has(near.pair.b.index()))  // most are not
        add_if_missed(near.pair, duration);
  std::vector<std::uint32_t> far;  // blocks of disks that deviate beyond what `near` holds
  for (auto const& disk : results.disks)
    if (disk.deviation > allowance) far.push_back(blocks.block_of(disk.slot));
  std::sort(far.begin(), far.end());
  far.erase(std::unique(far.begin(), far.end()), far.end());
  for (auto const b : far) {
    Block const& block = blocks.block(b);
    for (auto k = block.pairs[0]; k < block.pairs[pair_classes]; ++k) {
      auto const local = blocks.outer(k);
      if (std::min(local.a(), local.b()) >= block.own) continue;  // filling
      add_if_missed(slot_pair(blocks, block, local), duration);
    }
  }
  auto const missed = todo_.size();
  counters.again += static_cast<std::int64_t>(missed);
  for (std::size_t k = 0; k < missed; ++k) {
    auto const [a, b] = todo_[k];
    take_unit_of(a);
    take_unit_of(b.index());
  }
}

void LookaheadSteps::add_if_missed(SlotPair const& pair, Real duration) {
  auto const& all = disks_.system;
  auto const& results = scratch_.results;
  auto const a = pair.a, b = pair.b.index();
  Real const deviation = results.deviation(a) + results.deviation(b);
  if (deviation == 0) return;
  auto const& p = all.now.record(a);
  auto const q = at_image(all.now.record(b), pair.b.image(), scratch_.start);
  simd::Records const d{p.x - q.x, p.y - q.y, p.vx - q.vx, p.vy - q.vy};
  Real const distance = class_distance(pair_class(all.species(a), all.species(b)));
  if (!may_meet(d, distance + deviation, duration).any()) return;
  auto const same = [&](SlotPair const& o) {
    return (o.a == a && o.b.index() == b) || (o.a == b && o.b.index() == a);
  };
  if (std::any_of(todo_.begin(), todo_.end(), same)) return;
  if (results.has(a) && results.has(b) && results.of(a).unit == results.of(b).unit) {
    auto const& unit = results.units[results.of(a).unit];
    auto const pairs = results.pairs.begin();
    if (std::any_of(pairs + static_cast<std::ptrdiff_t>(unit.first_pair),
                    pairs + static_cast<std::ptrdiff_t>(unit.end_pair), same))
      return;
  }
  todo_.push_back(pair);
}

/// Discards the unit that holds a disk; its pairs are worked out again.
void LookaheadSteps::take_unit_of(std::uint32_t slot) {
  auto& results = scratch_.results;
  if (!results.has(slot)) return;
  auto& unit = results.units[results.of(slot).unit];
  if (!unit.alive) return;
  unit.alive = false;
  for (auto p = unit.first_pair; p < unit.end_pair; ++p) todo_.push_back(results.pairs[p]);
}

/// Adds the sampled configurations: batches as evaluated; all other disks by closed forms of free
/// flight, plus the differences that collisions make.
void LookaheadSteps::measure(Lookahead const& lookahead, Sampling const& sampling,
                             OpenWindows& windows) {
  auto const& times = scratch_.times;
  auto const& results = scratch_.results;
  auto const& all = disks_.system;
  if (times.size() == 0) return;
  for (auto const& disk : results.disks) in_batch_[disk.slot] = results.units[disk.unit].batch;
  free_.assign(all.blocks.count, {});
  (*disks_.loop)(all.blocks.count, [&](std::uint32_t b) {
    free_[b] = flight_sums(all, all.blocks.block(b), disks_.clock.strain_rate,
                           [&](std::uint32_t slot) { return simd::zero(in_batch_.data() + slot); });
  });
  FlightSums free;
  for (auto const& of_block : free_) free += of_block;
  for (std::size_t bin = 0; bin < times.bins(); ++bin) {
    auto const& powers = times.total(bin);
    if (powers.samples == 0) continue;
    BlockSums total;
    free.add_to(total, powers);
    for (auto const& unit : results.units)
      if (unit.alive) total += results.sums[unit.sums + bin];
    windows.add(sampling.window(lookahead.begin) + static_cast<std::int64_t>(bin),
                disks_.columns_of(total), powers.samples);
  }
}

/// Moves free disks to the end of the lookahead, and stores the others there.
void LookaheadSteps::commit(ShearedBox const& end, std::int64_t steps) {
  auto& all = disks_.system;
  auto const& flights = scratch_.flights;
  (*disks_.loop)(all.blocks.count, [&](std::uint32_t b) {
    Block const& block = all.blocks.block(b);
    fly(block, all.now.record.data() + block.first, flights.time(steps));
    if (!flights.at_one_rate()) scale_motion(block, all.now, flights.scale(steps));
  });
  for (auto const& disk : scratch_.results.disks) {
    simd::Record r = disk.record;
    Vec2<Real> const shift = end.shift(disk.image);
    r.x -= shift.x;
    r.y -= shift.y;
    r.vx -= end.velocity_shift(disk.image);
    all.now.record(disk.slot) = r;
    if (all.rotates) all.now.spin(disk.slot) = disk.spin;
  }
}

/// Adapts the allowance so that a disk deviates by more in one lookahead out of twenty. A larger
/// one means more near pairs, a smaller one more blocks searched again.
void LookaheadSteps::adapt_allowance() {
  auto const& disks = scratch_.results.disks;
  std::size_t beyond = 0;
  for (auto const& disk : disks) beyond += disk.deviation > usual;
  Real const largest = scratch_.results.largest_deviation();
  allowance *= largest > allowance ? 1.25 : 0.9884;  // 1.25 * 0.9884^19 = 1
  if (50 * beyond > disks.size()) usual *= 1.125;
  if (200 * beyond < disks.size()) usual *= 0.9375;
  usual = std::min(usual, allowance);
}

void LookaheadSteps::count(Lookahead& lookahead) {
  for (auto const& unit : scratch_.results.units)
    if (unit.alive) lookahead.contacts += unit.touching;
  ++counters.lookaheads;
  counters.steps += lookahead.steps();
  counters.binary += static_cast<std::int64_t>(lookahead.work.binary);
  counters.binary_steps += static_cast<std::int64_t>(lookahead.work.binary_steps);
  counters.others += static_cast<std::int64_t>(lookahead.work.others);
  counters.touching += std::llround(lookahead.contacts * static_cast<Real>(lookahead.steps()));
}

}  // namespace bagnold
