// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/islands/batches.hpp"
#include "kernels/islands/free_flight.hpp"
#include "kernels/observables/block_sums.hpp"
#include "src/simulation/block_loop.hpp"
#include "src/simulation/clock.hpp"
#include "src/simulation/sampling.hpp"

namespace bagnold {

/// The papers' scheme where most disks fly straight: a window of many steps at a time.
///
/// From straight flights it predicts which disks may meet within the window, steps only these, island
/// by island, and moves all others at once: for a disk that touches nothing the scheme is x += v dt.
/// A disk that meets another strays from its straight flight; it is taken to stray by an allowance, and
/// may then meet more. How far every disk strays is watched at each step: where further than it was
/// taken to, its outer pairs are looked at again, and if one could have touched unforeseen, the window
/// is done again with it.
template <ContactLaw Law, class Repulsion, class Space>
class WindowedSteps {
 public:
  using Step = BlockStep<Law, Repulsion>;
  static constexpr bool rotates = Law::rotates;

  /// What a window costs and finds; none of it is time, so it is the same on every machine.
  struct Counters {
    std::int64_t windows = 0, steps = 0;
    std::int64_t repeated = 0;  ///< windows done again
    std::int64_t active = 0;    ///< disks in islands, summed over windows, repeated ones too
    std::int64_t touching = 0;  ///< pairs, summed over windows and steps
  };

  struct Window {
    std::int64_t begin, end;  ///< [steps]
    std::int64_t list_step;   ///< of the outer list
    Real most_stray;          ///< that the outer list allows, [d_s]
    Real strayed = 0;         ///< out: the farthest stray, [d_s]
    Real active = 0;          ///< out: disks stepped, summed over repetitions
    Real touching = 0;        ///< out: pairs, mean over steps
  };

  Counters counters;
  Real allowance = 0;  ///< how far a disk may stray, [d_s]; 0: not known yet

  void rearranged(Step const& all) {
    finder_.resize(all.blocks.slots);
    strays_.assign(all.blocks.slots, 0);
    straying_.clear();
  }

  /// Does the window, adding its sampled configurations to `windows`. False, and nothing is changed,
  /// if most disks take part, one strays too far for the list, or a number is none or an overlap too
  /// large: then step by step.
  bool run(BlockLoop<Space>& loop, Step& all, Clock const& clock, Window& window,
           Sampling const& sampling, OpenWindows& windows, Real most_active) {
    ShearedBox const start = box_at(clock, window, window.begin);
    Real const duration = static_cast<Real>(window.end - window.begin) * clock.time_step;
    auto const disks = all.blocks.slot_of.extent(0);
    predict(loop, all, start, duration);
    for (bool again = false;; again = true) {
      if (again) ++counters.repeated;
      finder_.find(meeting_, islands_);
      if (!islands_.unfolds || static_cast<Real>(islands_.disks.size()) > most_active * disks)
        return false;
      if (!batches_.fill(islands_, all, start)) return false;
      window.active += static_cast<Real>(islands_.disks.size());
      if (!step_batches(loop, clock, window, sampling)) return false;
      window.strayed = farthest_stray();
      if (window.strayed > window.most_stray) return false;
      if (!add_missed(all, duration)) break;
    }
    measure(loop, all, clock, window, sampling, windows);
    commit(loop, all, box_at(clock, window, window.end), duration);
    adapt_allowance();
    ++counters.windows;
    counters.steps += window.end - window.begin;
    counters.active += static_cast<std::int64_t>(window.active);
    counters.touching += std::llround(window.touching * static_cast<Real>(window.end - window.begin));
    return true;
  }

 private:
  static ShearedBox box_at(Clock const& clock, Window const& window, std::int64_t step) {
    return {clock.box_length, clock.offset(step, window.list_step), clock.strain_rate};
  }

  void predict(BlockLoop<Space>& loop, Step const& all, ShearedBox const& box, Real duration) {
    found_.resize(all.blocks.count);
    loop(all.blocks.count, [&](std::uint32_t b) {
      Block const& block = all.blocks.block(b);
      found_[b].clear();
      refresh_halo(all.blocks, block, all.now, box);
      predict_contacts(all.blocks, block, all.now.record.data() + block.first, duration, allowance,
                       found_[b]);
    });
    for (auto const slot : straying_) strays_[slot] = 0;
    straying_.clear();
    meeting_.clear();
    auto const will_stray = [&](std::uint32_t slot) {
      if (strays_[slot]) return;
      strays_[slot] = 1;
      straying_.push_back(slot);
    };
    for (auto const& found : found_)
      for (auto const& pair : found.meeting) {
        meeting_.push_back(pair);
        will_stray(pair.a);
        will_stray(pair.b.index());
      }
    for (auto const& found : found_)
      for (auto const& [pair, with_one] : found.near) {
        int const straying = strays_[pair.a] + strays_[pair.b.index()];
        if (straying == 2 || (straying == 1 && with_one)) meeting_.push_back(pair);
      }
  }

  /// Steps every batch through the window. False if a motion is no number or an overlap too large.
  bool step_batches(BlockLoop<Space>& loop, Clock const& clock, Window& window,
                    Sampling const& sampling) {
    auto& step = batches_.step;
    auto const count = step.blocks.count;
    auto const bins = static_cast<std::size_t>(sampling.window(window.end - 1) -
                                               sampling.window(window.begin) + 1);
    sums_.assign(count * bins, {});
    outcome_.assign(count, {});
    ShearedBox const box{clock.box_length, 0, clock.strain_rate};
    loop.template with_scratch<typename Step::Force>(
        count, step.blocks.most_local, [&](std::uint32_t b, typename Step::Force* force) {
          DeviationWatch watch{batches_.origin.data(), batches_.deviation2.data(), 0,
                               clock.time_step};
          auto sample = sampling.next(window.begin);
          for (auto s = window.begin; s < window.end; ++s) {
            if (s == sample) {
              auto& sums = sums_[b * bins + static_cast<std::size_t>(sampling.window(s) -
                                                                     sampling.window(window.begin))];
              auto const here = measure_block(step, b, box, force);
              for (int c = 0; c < Sums<rotates>::columns; ++c) sums.value[c] += here.value[c];
              sample = sampling.next(s + 1);
            }
            step.predict(b, box, force);
            watch.time = static_cast<Real>(s + 1 - window.begin) * clock.time_step;
            auto const report = step.correct(b, box, force, watch);
            outcome_[b].touching += report.touching;
            outcome_[b].bad = outcome_[b].bad || report.poison != 0 ||
                              report.largest_overlap > largest_relative_overlap;
          }
        });
    std::int64_t touching = 0;
    for (auto const& outcome : outcome_) {
      if (outcome.bad) return false;
      touching += outcome.touching;
    }
    window.touching = static_cast<Real>(touching) / static_cast<Real>(window.end - window.begin);
    return true;
  }

  Real stray_of(std::uint32_t slot) const {
    auto const place = finder_.place_of(slot);
    return place == IslandFinder::none ? 0
                                       : std::sqrt(batches_.deviation2(batches_.slot_of[place]));
  }

  Real farthest_stray() const {
    Real largest = 0;
    for (auto const slot : batches_.slot_of) largest = std::max(largest, batches_.deviation2(slot));
    return std::sqrt(largest);
  }

  bool strayed_unforeseen(std::uint32_t slot) const {
    return stray_of(slot) > (strays_[slot] ? allowance : 0);
  }

  /// Looks again at the pairs of disks that strayed further than foreseen; adds those that could have
  /// touched. Whether there were any.
  bool add_missed(Step const& all, Real duration) {
    auto const before = meeting_.size();
    std::vector<std::uint32_t> strayed;
    for (auto const& disk : islands_.disks)
      if (strayed_unforeseen(disk.slot)) strayed.push_back(block_of(all.blocks, disk.slot));
    std::sort(strayed.begin(), strayed.end());
    strayed.erase(std::unique(strayed.begin(), strayed.end()), strayed.end());
    for (auto const b : strayed) add_missed_in(all, all.blocks.block(b), duration);
    return meeting_.size() > before;
  }

  static std::uint32_t block_of(Blocks const& blocks, std::uint32_t slot) {
    std::uint32_t low = 0, high = blocks.count;
    while (high - low > 1) {
      auto const middle = (low + high) / 2;
      (blocks.block(middle).first <= slot ? low : high) = middle;
    }
    return low;
  }

  void add_missed_in(Step const& all, Block const& block, Real duration) {
    auto const* record = all.now.record.data() + block.first;
    for (int c = 0; c < pair_classes; ++c)
      for (auto k = block.pairs[c]; k < block.pairs[c + 1]; ++k) {
        auto const local = all.blocks.outer(k);
        if (std::min(local.a(), local.b()) >= block.own) continue;  // filling
        auto const pair = slot_pair(all.blocks, block, local);
        if (!strayed_unforeseen(pair.a) && !strayed_unforeseen(pair.b.index())) continue;
        Real const stray = stray_of(pair.a) + stray_of(pair.b.index());
        simd::LocalPair const eight[simd::width] = {local, local, local, local,
                                                    local, local, local, local};
        auto const d = simd::load_differences(record, eight);
        if (!may_meet(d, class_distance(c) + stray, duration).any()) continue;
        auto const known = [&](SlotPair const& p) {
          return (p.a == pair.a && p.b.index() == pair.b.index()) ||
                 (p.a == pair.b.index() && p.b.index() == pair.a);
        };
        if (std::none_of(meeting_.begin(), meeting_.end(), known)) meeting_.push_back(pair);
      }
  }

  /// Adds the sampled configurations: islands as they were seen, free disks by closed forms.
  void measure(BlockLoop<Space>& loop, Step const& all, Clock const& clock, Window const& window,
               Sampling const& sampling, OpenWindows& windows) {
    auto sample = sampling.next(window.begin);
    if (sample >= window.end) return;
    free_.assign(all.blocks.count, {});
    loop(all.blocks.count, [&](std::uint32_t b) {
      free_[b] = free_flight_sums(all, all.blocks.block(b), clock.strain_rate,
                                  [&](std::uint32_t slot) { return finder_.free(slot); });
    });
    FreeFlightSums free;
    for (auto const& of_block : free_) free += of_block;

    auto const first = sampling.window(window.begin);
    while (sample < window.end) {
      auto const bin = sampling.window(sample);
      Real n = 0, t1 = 0, t2 = 0;  // samples, and sums of t and t^2 over them
      for (; sample < window.end && sampling.window(sample) == bin; sample = sampling.next(sample + 1)) {
        Real const t = static_cast<Real>(sample - window.begin) * clock.time_step;
        n += 1;
        t1 += t;
        t2 += t * t;
      }
      Sums<rotates> total;
      add_free_flight(total.value, free, n, t1, t2);
      auto const bins = sums_.size() / std::max<std::size_t>(1, outcome_.size());
      for (std::size_t b = 0; b < outcome_.size(); ++b)
        for (int c = 0; c < Sums<rotates>::columns; ++c)
          total.value[c] += sums_[b * bins + static_cast<std::size_t>(bin - first)].value[c];
      windows.add(bin, total.value, n);
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
  void commit(BlockLoop<Space>& loop, Step& all, ShearedBox const& end, Real duration) {
    loop(all.blocks.count, [&](std::uint32_t b) {
      Block const& block = all.blocks.block(b);
      fly(block, all.now.record.data() + block.first, duration);
    });
    for (std::size_t place = 0; place < islands_.disks.size(); ++place) {
      auto const& disk = islands_.disks[place];
      auto const slot = batches_.slot_of[place];
      simd::Record r = batches_.step.now.record(slot);
      Vec2<Real> const shift = end.shift(disk.image);
      r.x -= shift.x;
      r.y -= shift.y;
      r.vx -= end.velocity_shift(disk.image);
      all.now.record(disk.slot) = r;
      if constexpr (rotates) all.now.spin(disk.slot) = batches_.step.now.spin(slot);
    }
  }

  /// So large that one disk in a hundred strays further: fewer pairs foreseen, or fewer looked at
  /// again.
  void adapt_allowance() {
    std::size_t beyond = 0;
    for (auto const slot : straying_) beyond += stray_of(slot) > allowance;
    auto const active = straying_.size();
    if (50 * beyond > active) allowance *= 1.125;
    if (200 * beyond < active) allowance *= 0.9375;
  }

  struct Outcome {
    std::int64_t touching = 0;
    bool bad = false;
  };

  IslandFinder finder_;
  Islands islands_;
  Batches<Law, Repulsion> batches_;
  std::vector<Forecast> found_;         ///< by block
  std::vector<std::uint8_t> strays_;    ///< by slot: taken to stray
  std::vector<std::uint32_t> straying_;  ///< those slots
  std::vector<SlotPair> meeting_;
  std::vector<Sums<rotates>> sums_;  ///< [batches][measurement windows]
  std::vector<Outcome> outcome_;     ///< by batch
  std::vector<FreeFlightSums> free_;
};

}  // namespace bagnold
