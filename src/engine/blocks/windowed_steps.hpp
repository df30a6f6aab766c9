// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/cpu/islands/batches.hpp"
#include "kernels/cpu/islands/binary_collisions.hpp"
#include "kernels/cpu/islands/free_flight.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/clock.hpp"
#include "src/engine/sampling.hpp"
#include "src/engine/blocks/window_costs.hpp"
#include "src/engine/contacts/window_contacts.hpp"

namespace bagnold {

/// The step of a scheme where most disks fly straight: a window of many steps at a time.
///
/// From straight flights it foretells which disks meet within the window, steps only these, island by
/// island, and moves all others at once: for a disk that touches nothing the scheme is x += v dt. A
/// disk that meets another strays from its straight flight; how far is watched at every step. Pairs
/// that could have touched for that, unforeseen, are added, and their islands are done again, until
/// there are none.
template <class Step>
class WindowedSteps {
 public:
  static constexpr bool rotates = Step::rotates;

  /// What windows cost and find; none of it is time, so it is the same on every machine.
  struct Counters {
    std::int64_t windows = 0, steps = 0;
    std::int64_t again = 0;          ///< pairs found to have been missed, and added
    std::int64_t binary = 0;         ///< islands of two disks
    std::int64_t binary_steps = 0;   ///< of a pair
    std::int64_t others = 0;         ///< disks in larger islands, repetitions included
    std::int64_t touching = 0;       ///< pairs, summed over steps
  };

  struct Window {
    std::int64_t begin, end;  ///< [steps]
    std::int64_t list_step;   ///< of the outer list
    Real most_stray;          ///< that the outer list allows, [d_s]
    Real strayed = 0;         ///< out: the farthest stray, [d_s]
    Real contacts = 0;        ///< out: pairs touching, mean over steps; of islands of two done again, both times
    WindowWork work = {};     ///< out
  };

  Counters counters;
  Real allowance = 0;  ///< strays up to this are looked up quickly, [d_s]; 0: not known yet
  Real usual = 0;      ///< stray that one disk in a hundred exceeds, [d_s]
  bool cautious = false;  ///< near pairs of disks that meet others are stepped from the first

  /// The disks have other slots.
  void rearranged() {
    results_.clear();
    arranged_ = false;
  }

  /// Does the window, adding its sampled configurations to `windows`. False, and nothing is changed,
  /// if too many disks take part, one comes too far for the list, or a number is none or an overlap
  /// too large: then step by step.
  bool run(BlockLoop& loop, Step& all, Clock const& clock, Window& window,
           Sampling const& sampling, OpenWindows& windows, ContactWatch& watch, Real most_active) {
    forget();
    if (window.most_stray < 0) return false;
    if (!arranged_) arrange(all.blocks.slots);
    list_samples(window, clock, sampling);
    Real const duration = static_cast<Real>(window.end - window.begin) * clock.time_step;
    ShearedBox const start = box_at(clock, window, window.begin);
    contacts_.begin(watch, all, start, window.begin, sampling, windows);
    predict(loop, all, start, duration);
    Real const most = most_active * static_cast<Real>(all.blocks.slot_of.extent(0));
    while (!todo_.empty()) {
      finder_.find(todo_, islands_);
      if (!islands_.unfolds) return false;
      sort_islands();
      if (window.work.others + static_cast<Real>(larger_.disks.size()) > most) return false;
      if (!do_binary(loop, all, clock, start, window)) return false;
      if (!do_larger(loop, all, clock, start, window)) return false;
      window.strayed = farthest_stray();
      if (window.strayed > window.most_stray) return false;
      find_missed(all, start, duration);
    }
    measure(loop, all, clock, sampling, window, windows);
    if (contacts_)
      contacts_.tell(window.end, times_, sampling, windows,
                     [&](std::size_t unit) { return units_[unit].alive; });
    commit(loop, all, box_at(clock, window, window.end), duration);
    adapt_allowance();
    count(window);
    return true;
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t lanes = simd::width;
  using Binary = BinaryCollisions<typename Step::Law, typename Step::Repulsion, Step::scheme>;

  /// What is done at one go: a pair of disks, or a batch of larger islands.
  struct Unit {
    std::size_t first_pair, end_pair;  ///< in pairs_
    std::size_t sums;                  ///< its first in sums_
    bool batch;
    bool alive = true;  ///< false: done again with more pairs
    Real touching = 0;   ///< pairs in a batch, mean over steps
  };
  struct Result {
    std::uint32_t slot, unit;
    Image image;
    simd::Record record;  ///< at the end of the window
    Real spin;
    Real stray;  ///< [d_s]
  };

  static ShearedBox box_at(Clock const& clock, Window const& window, std::int64_t step) {
    return {clock.box_length, clock.offset(step, window.list_step), clock.strain_rate};
  }

  /// Room by slot, which runs without windows do not need.
  void arrange(std::uint32_t slots) {
    finder_.resize(slots);
    result_of_.assign(slots, none);
    in_batch_.assign(slots, 0);
    arranged_ = true;
  }

  void forget() {
    for (auto const& result : results_) {
      result_of_[result.slot] = none;
      in_batch_[result.slot] = 0;
    }
    results_.clear();
    units_.clear();
    pairs_.clear();
    sums_.clear();
  }

  void list_samples(Window const& window, Clock const& clock, Sampling const& sampling) {
    times_.clear();
    auto const first = sampling.window(window.begin);
    for (auto s = sampling.next(window.begin); s < window.end; s = sampling.next(s + 1))
      times_.add(s - window.begin, static_cast<std::size_t>(sampling.window(s) - first),
                 clock.time_step);
  }

  void predict(BlockLoop& loop, Step const& all, ShearedBox const& box, Real duration) {
    found_.resize(all.blocks.count);
    loop(all.blocks.count, [&](std::uint32_t b) {
      Block const& block = all.blocks.block(b);
      found_[b].clear();
      refresh_halo(all.blocks, block, all.now, box);
      predict_contacts(all.blocks, block, all.now.record.data() + block.first, duration, allowance,
                       usual, found_[b]);
    });
    todo_.clear();
    for (auto const& found : found_)
      todo_.insert(todo_.end(), found.meeting.begin(), found.meeting.end());
    if (cautious) add_near();
  }

  /// Adds the near pairs of disks that meet another.
  void add_near() {
    std::vector<std::uint32_t> straying;
    auto const stray = [&](std::uint32_t slot) {
      in_batch_[slot] = 1;
      straying.push_back(slot);
    };
    for (auto const& pair : todo_) {
      stray(pair.a);
      stray(pair.b.index());
    }
    for (auto const& found : found_)
      for (auto const& [pair, straying_ones] : found.near)
        if (in_batch_[pair.a] + in_batch_[pair.b.index()] >= straying_ones) todo_.push_back(pair);
    for (auto const slot : straying) in_batch_[slot] = 0;
  }

  /// Islands of two disks by themselves, the others together.
  void sort_islands() {
    binary_.clear();
    larger_.disks.clear();
    larger_.pairs.clear();
    larger_.first_disk.assign(1, 0);
    larger_.first_pair.assign(1, 0);
    for (std::size_t i = 0; i < islands_.count(); ++i) {
      auto const disk = islands_.first_disk[i], end_disk = islands_.first_disk[i + 1];
      auto const pair = islands_.first_pair[i], end_pair = islands_.first_pair[i + 1];
      if (end_disk - disk == 2 && end_pair - pair == 1) {
        binary_.push_back(islands_.pairs[pair]);
        continue;
      }
      auto const shift = static_cast<std::uint32_t>(larger_.disks.size()) - disk;  // modulo 2^32
      larger_.disks.insert(larger_.disks.end(), islands_.disks.begin() + disk,
                           islands_.disks.begin() + end_disk);
      for (auto p = pair; p < end_pair; ++p)
        larger_.pairs.push_back({islands_.pairs[p].a + shift, islands_.pairs[p].b + shift});
      larger_.first_disk.push_back(static_cast<std::uint32_t>(larger_.disks.size()));
      larger_.first_pair.push_back(static_cast<std::uint32_t>(larger_.pairs.size()));
    }
  }

  SlotPair slot_pair_of(Islands const& islands, Islands::Pair const& pair) const {
    auto const &a = islands.disks[pair.a], &b = islands.disks[pair.b];
    return {a.slot, Neighbor::make(b.slot, {b.image.m - a.image.m, b.image.n - a.image.n})};
  }

  void add_result(Islands::Disk const& disk, std::size_t unit) {
    if (result_of_[disk.slot] == none) {
      result_of_[disk.slot] = static_cast<std::uint32_t>(results_.size());
      results_.push_back({});
    }
    auto& result = results_[result_of_[disk.slot]];
    result.slot = disk.slot;
    result.image = disk.image;
    result.unit = static_cast<std::uint32_t>(unit);
  }

  Unit& add_unit(bool batch) {
    units_.push_back({pairs_.size(), pairs_.size(), sums_.size(), batch});
    sums_.resize(sums_.size() + times_.bins());
    if (contacts_) contacts_.add_unit(times_.bins());
    return units_.back();
  }

  bool do_binary(BlockLoop& loop, Step const& all, Clock const& clock,
                 ShearedBox const& start, Window& window) {
    auto const pairs = static_cast<std::uint32_t>(binary_.size());
    if (pairs == 0) return true;
    auto const first_unit = units_.size();
    for (auto const& pair : binary_) {
      auto& unit = add_unit(false);
      pairs_.push_back(slot_pair_of(islands_, pair));
      unit.end_pair = pairs_.size();
      add_result(islands_.disks[pair.a], units_.size() - 1);
      add_result(islands_.disks[pair.b], units_.size() - 1);
    }
    Binary const collisions{all.forces.law, all.forces.repulsion, all.table,
                            clock.time_step, clock.strain_rate, all.second_look()};
    auto const groups = (pairs + lanes - 1) / lanes;
    lane_outcome_.assign(groups, {});
    loop(groups, [&](std::uint32_t g) {
      typename Binary::Disk a[lanes], b[lanes];
      auto const begin = g * lanes, end = std::min(begin + lanes, pairs);
      for (auto i = begin; i < end; ++i) {
        a[i - begin] = disk_of(all, start, islands_.disks[binary_[i].a]);
        b[i - begin] = disk_of(all, start, islands_.disks[binary_[i].b]);
      }
      auto const run = [&](auto&& watch) {
        return collisions.run(a, b, static_cast<int>(end - begin), window.end - window.begin, times_,
                              sums_.data() + units_[first_unit + begin].sums, watch);
      };
      lane_outcome_[g] = contacts_ ? run(lane_watch(all, begin, end, first_unit)) : run(NoLaneWatch{});
      for (auto i = begin; i < end; ++i) {
        keep(islands_.disks[binary_[i].a].slot, a[i - begin]);
        keep(islands_.disks[binary_[i].b].slot, b[i - begin]);
      }
    });
    for (auto const& outcome : lane_outcome_) {
      if (outcome.bad) return false;
      window.contacts += static_cast<Real>(outcome.touching) /
                         static_cast<Real>(window.end - window.begin);
      window.work.binary_steps += static_cast<Real>(outcome.steps);
    }
    window.work.binary += pairs;
    return true;
  }

  /// Of binary_[begin .. end - 1].
  LaneWatch lane_watch(Step const& all, std::uint32_t begin, std::uint32_t end,
                       std::size_t first_unit) {
    LaneWatch watch;
    for (auto i = begin; i < end; ++i)
      contacts_.set_lane(all, watch, static_cast<int>(i - begin), first_unit + i,
                         islands_.disks[binary_[i].a].slot, islands_.disks[binary_[i].b].slot);
    return watch;
  }

  typename Binary::Disk disk_of(Step const& all, ShearedBox const& box,
                                Islands::Disk const& disk) const {
    Real spin = 0;
    if constexpr (rotates) spin = all.now.spin(disk.slot);
    return {at_image(all.now.record(disk.slot), disk.image, box), spin, all.species(disk.slot), 0};
  }

  void keep(std::uint32_t slot, typename Binary::Disk const& disk) {
    auto& result = results_[result_of_[slot]];
    result.record = disk.record;
    result.spin = disk.spin;
    result.stray = std::sqrt(disk.stray2);
  }

  /// Steps every batch of larger islands through the window.
  bool do_larger(BlockLoop& loop, Step const& all, Clock const& clock,
                 ShearedBox const& start, Window& window) {
    if (larger_.disks.empty()) return true;
    if (!batches_.fill(larger_, all, start)) return false;
    window.work.others += static_cast<Real>(larger_.disks.size());
    window.work.batches += static_cast<Real>(batches_.step.blocks.count);
    auto& step = batches_.step;
    auto const count = step.blocks.count;
    auto const first_unit = units_.size();
    for (std::uint32_t b = 0; b < count; ++b) {
      auto& unit = add_unit(true);
      auto const [begin, end] = batches_.stretch(b);
      for (auto p = larger_.first_pair[begin]; p < larger_.first_pair[end]; ++p)
        pairs_.push_back(slot_pair_of(larger_, larger_.pairs[p]));
      unit.end_pair = pairs_.size();
      for (auto d = larger_.first_disk[begin]; d < larger_.first_disk[end]; ++d)
        add_result(larger_.disks[d], units_.size() - 1);
    }
    outcome_.assign(count, {});
    auto const slot = [&](std::uint32_t b, std::uint32_t local) {
      return larger_.disks[larger_.first_disk[batches_.stretch(b).first_island] + local].slot;
    };
    auto const look = [&](std::uint32_t b, std::int64_t steps) {
      if (contacts_)
        contacts_.look(step, b, first_unit + b, steps, slot);
    };
    if (contacts_) contacts_.list_batches(step.blocks, slot);
    ShearedBox const box{clock.box_length, 0, clock.strain_rate};
    loop.with_scratch<typename Step::Force>(
        count, step.blocks.most_local * std::size_t{Step::observed_forces},
        [&](std::uint32_t b, typename Step::Force* force) {
          DeviationWatch watch{batches_.origin.data(), batches_.deviation2.data(), 0,
                               clock.time_step};
          std::size_t sample = 0;
          std::int64_t const steps = window.end - window.begin;
          bool idle = true;
          for (std::int64_t s = 0; s < steps; ++s) {
            look(b, s);
            if (idle) {
              auto const last = s + leap(b, s, steps - s, sample, first_unit, clock);
              if (last > s) watch.all_of(step.blocks.block(b), step.now.record.data(), last);
              s = last;
              if (s == steps) break;
              look(b, s);
            }
            auto report = step.predict(b, box, force);
            bool const sampled = sample < times_.size() && s == times_.step(sample);
            if (sampled) {
              auto& sums = sums_[units_[first_unit + b].sums + times_.bin(sample)];
              auto const here = measure_block(step, b, clock.strain_rate, force);
              for (int c = 0; c < Sums<rotates>::columns; ++c) sums.value[c] += here.value[c];
              if (contacts_)
                contacts_.sample(step, b, first_unit + b, times_.bin(sample), s, slot);
              ++sample;
            }
            watch.time = static_cast<Real>(s + 1) * clock.time_step;
            report += step.correct(b, box, force, sampled, watch);
            idle = report.touching == 0;
            outcome_[b].touching += report.touching;
            outcome_[b].bad = outcome_[b].bad || report.poison != 0 ||
                              report.largest_overlap > largest_relative_overlap;
          }
        });
    for (std::uint32_t b = 0; b < count; ++b) {
      if (outcome_[b].bad) return false;
      Real& touching = units_[first_unit + b].touching;
      touching = static_cast<Real>(outcome_[b].touching) /
                 static_cast<Real>(window.end - window.begin);
      window.work.touching += touching;
    }
    for (std::size_t d = 0; d < larger_.disks.size(); ++d) {
      auto const from = batches_.slot_of[d];
      auto& result = results_[result_of_[larger_.disks[d].slot]];
      result.record = step.now.record(from);
      if constexpr (rotates) result.spin = step.now.spin(from);
      result.stray = std::sqrt(batches_.deviation2(from));
    }
    return true;
  }

  /// Flies batch b straight for as many steps as none of its pairs touches, which it returns; adds the
  /// configurations sampled on the way.
  std::int64_t leap(std::uint32_t b, std::int64_t from, std::int64_t most, std::size_t& sample,
                    std::size_t first_unit, Clock const& clock) {
    auto& step = batches_.step;
    Block const& block = step.blocks.block(b);
    auto* const records = step.now.record.data() + block.first;
    auto const steps = free_steps(step.blocks, block, records, clock.time_step, most);
    if (steps == 0) return 0;
    auto const end = times_.from(from + steps);
    if (end > sample) {
      auto const free = free_flight_sums(step, block, clock.strain_rate,
                                         [](std::uint32_t) { return simd::Mask::of(0xff); });
      times_.some(sample, end, from, clock.time_step,
                  [&](std::size_t bin, SampleTimes::Powers const& t) {
                    add_free_flight(sums_[units_[first_unit + b].sums + bin].value, free, t.n, t.t1,
                                    t.t2);
                  });
      sample = end;
    }
    fly(block, records, static_cast<Real>(steps) * clock.time_step);
    return steps;
  }

  bool stepped(std::uint32_t slot) const { return result_of_[slot] != none; }

  Real stray_of(std::uint32_t slot) const {
    return stepped(slot) ? results_[result_of_[slot]].stray : 0;
  }

  Real farthest_stray() const {
    Real largest = 0;
    for (auto const& result : results_) largest = std::max(largest, result.stray);
    return largest;
  }

  /// Fills todo_ with the pairs that could have touched, unforeseen, for the strays that were found,
  /// and with all pairs of the units that these disks are in.
  void find_missed(Step const& all, ShearedBox const& start, Real duration) {
    todo_.clear();
    for (auto const& found : found_)
      for (auto const& near : found.near)
        if (stepped(near.pair.a) || stepped(near.pair.b.index()))  // most are not
          add_if_missed(all, start, duration, near.pair);
    std::vector<std::uint32_t> far;  // blocks of disks that strayed beyond what `near` holds
    for (auto const& result : results_)
      if (result.stray > allowance) far.push_back(block_of(all.blocks, result.slot));
    std::sort(far.begin(), far.end());
    far.erase(std::unique(far.begin(), far.end()), far.end());
    for (auto const b : far) {
      Block const& block = all.blocks.block(b);
      for (auto k = block.pairs[0]; k < block.pairs[pair_classes]; ++k) {
        auto const local = all.blocks.outer(k);
        if (std::min(local.a(), local.b()) >= block.own) continue;  // filling
        add_if_missed(all, start, duration, slot_pair(all.blocks, block, local));
      }
    }
    auto const missed = todo_.size();
    counters.again += static_cast<std::int64_t>(missed);
    for (std::size_t k = 0; k < missed; ++k) {
      take_unit_of(todo_[k].a);
      take_unit_of(todo_[k].b.index());
    }
  }

  void add_if_missed(Step const& all, ShearedBox const& start, Real duration,
                     SlotPair const& pair) {
    auto const b = pair.b.index();
    Real const stray = stray_of(pair.a) + stray_of(b);
    if (stray == 0) return;
    auto const& p = all.now.record(pair.a);
    auto const q = at_image(all.now.record(b), pair.b.image(), start);
    simd::Records const d{p.x - q.x, p.y - q.y, p.vx - q.vx, p.vy - q.vy};
    Real const distance = class_distance(pair_class(all.species(pair.a), all.species(b)));
    if (!may_meet(d, distance + stray, duration).any()) return;
    auto const same = [&](SlotPair const& o) {
      return (o.a == pair.a && o.b.index() == b) || (o.a == b && o.b.index() == pair.a);
    };
    if (std::any_of(todo_.begin(), todo_.end(), same)) return;
    auto const unit_a = result_of_[pair.a], unit_b = result_of_[b];
    if (unit_a != none && unit_b != none && results_[unit_a].unit == results_[unit_b].unit) {
      Unit const& unit = units_[results_[unit_a].unit];
      if (std::any_of(pairs_.begin() + unit.first_pair, pairs_.begin() + unit.end_pair, same))
        return;
    }
    todo_.push_back(pair);
  }

  /// Its disks will be done again.
  void take_unit_of(std::uint32_t slot) {
    if (!stepped(slot)) return;
    Unit& unit = units_[results_[result_of_[slot]].unit];
    if (!unit.alive) return;
    unit.alive = false;
    for (auto p = unit.first_pair; p < unit.end_pair; ++p) todo_.push_back(pairs_[p]);
  }

  static std::uint32_t block_of(Blocks const& blocks, std::uint32_t slot) {
    std::uint32_t low = 0, high = blocks.count;
    while (high - low > 1) {
      auto const middle = (low + high) / 2;
      (blocks.block(middle).first <= slot ? low : high) = middle;
    }
    return low;
  }

  /// Adds the sampled configurations: batches as they were seen; all other disks as if in free flight,
  /// by closed forms, and what collisions changed.
  void measure(BlockLoop& loop, Step const& all, Clock const& clock,
               Sampling const& sampling, Window const& window, OpenWindows& windows) {
    if (times_.size() == 0) return;
    for (auto const& result : results_) in_batch_[result.slot] = units_[result.unit].batch;
    free_.assign(all.blocks.count, {});
    loop(all.blocks.count, [&](std::uint32_t b) {
      free_[b] = free_flight_sums(all, all.blocks.block(b), clock.strain_rate,
                                  [&](std::uint32_t slot) {
                                    return simd::zero(in_batch_.data() + slot);
                                  });
    });
    FreeFlightSums free;
    for (auto const& of_block : free_) free += of_block;
    for (std::size_t bin = 0; bin < times_.bins(); ++bin) {
      Sums<rotates> total;
      auto const& [n, t1, t2] = times_.total(bin);
      if (n == 0) continue;
      add_free_flight(total.value, free, n, t1, t2);
      for (auto const& unit : units_)
        if (unit.alive)
          for (int c = 0; c < Sums<rotates>::columns; ++c)
            total.value[c] += sums_[unit.sums + bin].value[c];
      windows.add(sampling.window(window.begin) + static_cast<std::int64_t>(bin), total.value, n);
    }
  }

  static void add_free_flight(Real* to, FreeFlightSums const& free, Real n, Real t1, Real t2) {
    using C = SumColumns;
    auto const xx = [&](auto const& m) { return m.aa * n + 2 * m.ab * t1 + m.bb * t2; };
    to[C::kinetic_xx] += xx(free.mass);
    to[C::kinetic_xy] += free.mass.av * n + free.mass.bv * t1;
    to[C::kinetic_yy] += free.mass.vv * n;
    to[C::velocity_x2] += xx(free.plain);
    to[C::velocity_y2] += free.plain.vv * n;
    if constexpr (rotates) {
      to[C::spin] += free.spin * n;
      to[C::spin2] += free.spin2 * n;
    }
  }

  /// Moves free disks to the end of the window, and puts the others there.
  void commit(BlockLoop& loop, Step& all, ShearedBox const& end, Real duration) {
    loop(all.blocks.count, [&](std::uint32_t b) {
      Block const& block = all.blocks.block(b);
      fly(block, all.now.record.data() + block.first, duration);
    });
    for (auto const& result : results_) {
      simd::Record r = result.record;
      Vec2<Real> const shift = end.shift(result.image);
      r.x -= shift.x;
      r.y -= shift.y;
      r.vx -= end.velocity_shift(result.image);
      all.now.record(result.slot) = r;
      if constexpr (rotates) all.now.spin(result.slot) = result.spin;
    }
  }

  /// The allowance so large that a disk strays further in one window out of twenty: more pairs near,
  /// or more blocks looked through again.
  void adapt_allowance() {
    std::size_t beyond = 0;
    Real largest = 0;
    for (auto const& result : results_) {
      beyond += result.stray > usual;
      largest = std::max(largest, result.stray);
    }
    allowance *= largest > allowance ? 1.25 : 0.9884;  // 1.25 * 0.9884^19 = 1
    if (50 * beyond > results_.size()) usual *= 1.125;
    if (200 * beyond < results_.size()) usual *= 0.9375;
    usual = std::min(usual, allowance);
  }

  void count(Window& window) {
    auto const steps = window.end - window.begin;
    for (auto const& unit : units_)
      if (unit.alive) window.contacts += unit.touching;
    ++counters.windows;
    counters.steps += steps;
    counters.binary += static_cast<std::int64_t>(window.work.binary);
    counters.binary_steps += static_cast<std::int64_t>(window.work.binary_steps);
    counters.others += static_cast<std::int64_t>(window.work.others);
    counters.touching += std::llround(window.contacts * static_cast<Real>(steps));
  }

  struct Outcome {
    std::int64_t touching = 0;
    bool bad = false;
  };

  bool arranged_ = false;  ///< the room by slot is that of the blocks
  IslandFinder finder_;
  Islands islands_, larger_;
  std::vector<Islands::Pair> binary_;
  Batches<Step> batches_;
  SampleTimes times_;
  std::vector<Forecast> found_;  ///< by block
  std::vector<SlotPair> todo_;
  std::vector<std::uint32_t> result_of_;  ///< by slot: its place in results_, or none
  std::vector<std::uint8_t> in_batch_;    ///< by slot
  std::vector<Result> results_;           ///< a disk each
  std::vector<Unit> units_;
  std::vector<SlotPair> pairs_;        ///< of all units
  std::vector<Sums<rotates>> sums_;    ///< a measurement window each, for every unit
  WindowContacts contacts_;
  std::vector<typename Binary::Outcome> lane_outcome_;
  std::vector<Outcome> outcome_;  ///< by batch
  std::vector<FreeFlightSums> free_;
};

}  // namespace bagnold
