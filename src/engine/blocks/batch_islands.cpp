// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/batch_islands.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/cpu/islands/free_flight.hpp"

namespace bagnold {

bool BatchIslands::run(BlockDisks const& disks, Lookahead& lookahead, LookaheadScratch& scratch) {
  if (islands.disks.empty()) return true;
  auto const& stepper = *disks.stepper;
  if (!batches_.fill(islands, disks.system, stepper.uses(Uses::contact_pairs), scratch.start))
    return false;
  auto& system = batches_.system;
  auto& results = scratch.results;
  auto const count = system.blocks.count;
  lookahead.work.others += static_cast<Real>(islands.disks.size());
  lookahead.work.batches += static_cast<Real>(count);
  add_units(scratch);
  outcome_.assign(count, {});
  sums_.resize(count);
  if (scratch.contacts)
    scratch.contacts.list_batches(system.blocks,
                                  [&](auto b, auto local) { return slot(b, local); });
  auto const room = system.blocks.most_local * stepper.scratch;
  disks.loop->with_scratch<std::byte>(count, room, [&](std::uint32_t b, std::byte* force) {
    run_batch(b, disks, lookahead, scratch, force);
  });
  for (std::uint32_t b = 0; b < count; ++b) {
    if (outcome_[b].bad) return false;
    Real& touching = results.units[first_unit_ + b].touching;
    touching = static_cast<Real>(outcome_[b].touching) / static_cast<Real>(lookahead.steps());
    lookahead.work.touching += touching;
  }
  for (std::size_t d = 0; d < islands.disks.size(); ++d) {
    auto const from = batches_.slot_of[d];
    auto& result = results.of(islands.disks[d].slot);
    result.record = system.now.record(from);
    if (system.rotates) result.spin = system.now.spin(from);
    result.deviation = std::sqrt(batches_.flight_deviation2(from));
  }
  return true;
}

void BatchIslands::add_units(LookaheadScratch& scratch) {
  auto& results = scratch.results;
  first_unit_ = results.units.size();
  for (std::uint32_t b = 0; b < batches_.system.blocks.count; ++b) {
    scratch.add_unit(true);
    auto const [begin, end] = batches_.stretch(b);
    for (auto p = islands.first_pair[begin]; p < islands.first_pair[end]; ++p)
      results.add_pair(islands, islands.pairs[p]);
    for (auto d = islands.first_disk[begin]; d < islands.first_disk[end]; ++d)
      results.add_disk(islands.disks[d]);
  }
}

/// Steps one batch through the lookahead, step by step or by leaps.
void BatchIslands::run_batch(std::uint32_t b, BlockDisks const& disks, Lookahead const& lookahead,
                             LookaheadScratch& scratch, void* force) {
  auto const& system = batches_.system;
  auto const& clock = disks.clock;
  auto const& times = scratch.times;
  auto& contacts = scratch.contacts;
  auto const unit = first_unit_ + b;
  auto const slot_of = [&](std::uint32_t batch, std::uint32_t local) { return slot(batch, local); };
  StepAt at{.box = scratch.start, .next_box = scratch.start};
  at.box.offset = at.next_box.offset = 0;  // islands are unfolded: no image is asked for
  auto const& flights = scratch.flights;
  FlightDeviation flight{batches_.origin.data(), batches_.flight_deviation2.data(), 0,
                         clock.time_step};
  std::size_t sample = 0;
  bool idle = true;
  for (std::int64_t s = 0; s < lookahead.steps(); ++s) {
    if (contacts) contacts.detect(system, b, unit, s, slot_of);
    if (idle) {
      auto const last = s + leap(b, clock, s, lookahead.steps() - s, sample, scratch);
      if (last > s) {
        flight.time = flights.time(last);
        flight.time_step = clock.time_step;
        flight.scale = flights.scale(last);
        flight.all_of(system.blocks.block(b), system.now.record.data());
      }
      s = last;
      if (s == lookahead.steps()) break;
      if (contacts) contacts.detect(system, b, unit, s, slot_of);
    }
    bool const sampled = sample < times.size() && s == times.step(sample);
    auto const bin = sampled ? times.bin(sample++) : 0;
    if (sampled && contacts) contacts.sample(system, b, unit, bin, s, slot_of);
    at.box.strain_rate = flights.scale(s) * clock.strain_rate;
    auto const factor = flights.scale(s, s + 1);
    flight.time = flights.time(s + 1);
    flight.time_step = factor * clock.time_step;
    flight.scale = flights.scale(s);
    at.sums = sampled ? sums_.data() : nullptr;
    BlockReport report;
    for (auto const& pass : disks.stepper->many)
      if (pass->belongs(sampled)) report += pass->run(system, b, at, force);
    if (sampled) scratch.results.sums[scratch.results.units[unit].sums + bin] += sums_[b];
    flight.all_of(system.blocks.block(b), system.now.record.data());
    if (factor != 1) scale_motion(system.blocks.block(b), system.now, factor);
    idle = report.touching == 0;
    outcome_[b].touching += report.touching;
    outcome_[b].bad = outcome_[b].bad || report.nan_flag != 0 ||
                      report.largest_overlap > largest_relative_overlap;
  }
}

/// Flies batch b straight for as many steps as none of its pairs touches, and returns their number.
/// Adds the configurations sampled on the way.
std::int64_t BatchIslands::leap(std::uint32_t b, Clock const& clock, std::int64_t from,
                                std::int64_t most, std::size_t& sample, LookaheadScratch& scratch) {
  auto const& system = batches_.system;
  auto const& times = scratch.times;
  Block const& block = system.blocks.block(b);
  auto* const records = system.now.record.data() + block.first;
  auto const& flights = scratch.flights;
  Real const free_for = free_time(system.blocks, block, records, flights.longer_than(from, most));
  auto const until = static_cast<std::int64_t>(flights.steps_until(from, free_for) - 1);
  auto const steps = std::clamp(until, std::int64_t{0}, most);  // less one for rounding
  if (steps == 0) return 0;
  auto const end = times.from(from + steps);
  if (end > sample) {
    auto const free = flight_sums(system, block, flights.scale(from) * clock.strain_rate,
                                  [](std::uint32_t) { return simd::first_lanes(simd::width); });
    auto const first = scratch.results.units[first_unit_ + b].sums;
    times.some(sample, end, from, flights, [&](std::size_t bin, SampleTimes::Powers const& powers) {
      free.add_to(scratch.results.sums[first + bin], powers);
    });
    sample = end;
  }
  fly(block, records, flights.time(from, from + steps));
  if (auto const factor = flights.scale(from, from + steps); factor != 1)
    scale_motion(block, system.now, factor);
  return steps;
}

}  // namespace bagnold
