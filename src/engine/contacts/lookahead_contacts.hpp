// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/contacts/contact_changes.hpp"
#include "kernels/cpu/contacts/lane_detector.hpp"
#include "kernels/cpu/islands/sample_times.hpp"
#include "src/engine/contacts/contact_detector.hpp"

namespace bagnold {

/// Contacts of a lookahead, kept by unit of work until it is known which units count.
class LookaheadContacts {
 public:
  /// Begins a lookahead, after all contacts of the configurations before it have been recorded.
  /// Closes those that have parted in its first configuration, which no unit may see.
  void begin(ContactDetector& detector, BlockSystem const& all, ShearedBox const& box,
             std::int64_t step, Sampling const& sampling, OpenWindows& windows) {
    on_ = windows.contacts != nullptr;
    if (!on_) return;
    for (auto& events : events_) events.clear();
    for (auto& samples : samples_) samples.clear();
    for (auto& picks : picks_) picks.clear();
    motion_.clear();
    units_ = 0;
    begin_ = step;
    detector.close_parted(all, box, step, sampling, windows);
    detector_ = &detector;
    table_ = &windows.contacts->table;
    choice_ = windows.contacts->choice;
    picker_ = windows.contacts->picker();
    strain_rate_ = box.strain_rate;
  }

  explicit operator bool() const { return on_; }

  /// bins: measurement windows.
  void add_unit(std::size_t bins) {
    ++units_;
    bins_ = bins;
    if (events_.size() < units_) {
      events_.emplace_back();
      samples_.emplace_back();
      picks_.emplace_back();
    }
    motion_.resize(units_ * bins);
  }

  /// Assigns a pair of slots, as a unit, to lane k.
  void set_lane(BlockSystem const& all, LaneDetector& lanes, int k, std::size_t unit,
                std::uint32_t slot_a, std::uint32_t slot_b) {
    lanes.begin = begin_;
    lanes.choice = choice_;
    lanes.picker = picker_;
    lanes.strain_rate = strain_rate_;
    auto& lane = lanes.lane[k];
    lane = {detector_->disk(slot_a),       detector_->disk(slot_b), &events_[unit],
            motion_.data() + unit * bins_, &samples_[unit],         &picks_[unit]};
    Real const a = all.table.diameter[all.species(slot_a)];
    Real const b = all.table.diameter[all.species(slot_b)];
    lane.share_a = a / (a + b);
    lane.share_b = b / (a + b);
    if (auto const* const contact = open(slot_a, slot_b)) {
      lanes.touched |= 1u << k;
      lane.opened = contact->begin;
      lane.due = contact->due;
    }
  }

  /// Takes batches as blocks; slot(b, local): slot, in the system, of a disk of a batch.
  template <class Slot>
  void list_batches(Blocks const& blocks, Slot const& slot) {
    touched_.assign(blocks.block(blocks.count - 1).pairs[pair_classes] / simd::width, 0);
    sampled_.resize(std::max<std::size_t>(sampled_.size(), blocks.count));
    for (std::uint32_t b = 0; b < blocks.count; ++b) {
      sampled_[b].clear();
      fill_touched(blocks, blocks.block(b), touched_.data(), [&](simd::LocalPair const& pair) {
        auto const* const contact = open(slot(b, pair.a()), slot(b, pair.b()));
        if (choice_ && contact != nullptr)
          sampled_[b].push_back({pair.a(), pair.b(), contact->begin, contact->due});
        return contact != nullptr;
      });
    }
  }

  /// Detects contacts that begin or end in batch b of `step` after `steps` steps of the lookahead,
  /// and samples their velocities.
  template <class Slot>
  void detect(BlockSystem const& step, std::uint32_t b, std::size_t unit, std::int64_t steps,
              Slot const& slot) {
    Block const& block = step.blocks.block(b);
    auto const* const records = step.now.record.data() + block.first;
    auto const now = begin_ + steps;
    auto const disk = [&](std::uint32_t local) { return detector_->disk(slot(b, local)); };
    contact_changes(step.blocks, block, records, touched_.data(),
                    [&](simd::LocalPair const& pair, bool begins, Vec2<Real> const& separation,
                        Vec2<Real> const& velocity) {
                      events_[unit].push_back(contact_event(now, begins, disk(pair.a()),
                                                            disk(pair.b()), separation, velocity));
                      if (choice_) begin_or_end(sampled_[b], pair, begins, now);
                    });
    if (!choice_) return;
    for (auto& contact : sampled_[b]) {
      if (contact.due != now) continue;
      auto const &p = records[contact.a], &q = records[contact.b];
      Real const spin = step.common_spin(block.first + contact.a, block.first + contact.b);
      samples_[unit].push_back(
          {now, disk(contact.a), disk(contact.b),
           contact_velocities({p.x - q.x, p.y - q.y}, {p.vx - q.vx, p.vy - q.vy}, spin,
                              strain_rate_)});
      contact.due = choice_.next(disk(contact.a), disk(contact.b), contact.begin, now);
    }
  }

  /// Adds a batch's sums after `steps` steps of the lookahead to a measurement window.
  template <class Slot>
  void sample(BlockSystem const& step, std::uint32_t b, std::size_t unit, std::size_t bin,
              std::int64_t steps, Slot const& slot) {
    Block const& block = step.blocks.block(b);
    motion_[unit * bins_ + bin] += contact_motion(
        step.blocks, block, step.now.record.data() + block.first, touched_.data(),
        [&](int c, simd::LocalPair const& pair) { return step.common_spin(block, c, pair); },
        [&](simd::LocalPair const& pair, Vec2<Real> const& separation, Vec2<Real> const& velocity,
            Real spin) {
          picker_(picks_[unit], begin_ + steps, detector_->disk(slot(b, pair.a())),
                  detector_->disk(slot(b, pair.b())),
                  [&] { return contact_velocities(separation, velocity, spin, strain_rate_); });
        });
  }

  /// Ends a lookahead that counts: records the contacts of the units for which counts(unit) holds.
  template <class Counts>
  void tell(std::int64_t end, SampleTimes const& times, Sampling const& sampling,
            OpenWindows& windows, Counts const& counts) {
    ContactRecord& record = *windows.contacts;
    std::vector<ContactMotion> motion(times.bins());
    for (std::size_t unit = 0; unit < units_; ++unit) {
      if (!counts(unit)) continue;
      detector_->take(events_[unit]);
      detector_->take(samples_[unit]);
      record.add(picks_[unit]);
      for (std::size_t bin = 0; bin < times.bins(); ++bin)
        motion[bin] += motion_[unit * bins_ + bin];
    }
    detector_->tell(sampling, windows);
    for (std::size_t k = 0; k < times.size(); ++k)
      if (k == 0 || times.bin(k) != times.bin(k - 1))
        record.add(motion[times.bin(k)], begin_ + times.step(k), sampling, windows);
    record.evaluated(begin_, end, sampling, windows);
  }

 private:
  /// A contact of a batch whose velocities will be sampled.
  struct SampledContact {
    std::uint32_t a, b;  ///< in the batch
    std::int64_t begin, due;
  };

  OpenContact const* open(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return table_->find(detector_->disk(slot_a), detector_->disk(slot_b));
  }

  void begin_or_end(std::vector<SampledContact>& sampled, simd::LocalPair const& pair, bool begins,
                    std::int64_t now) const {
    if (begins)
      sampled.push_back(
          {pair.a(), pair.b(), now, now == 0 ? SampleChoice::never : choice_.first(now)});
    else
      std::erase_if(sampled,
                    [&](SampledContact const& w) { return w.a == pair.a() && w.b == pair.b(); });
  }

  bool on_ = false;
  ContactDetector* detector_ = nullptr;
  ContactTable const* table_ = nullptr;
  std::int64_t begin_ = 0;  ///< of the lookahead, [steps]
  std::size_t units_ = 0, bins_ = 0;
  std::vector<std::vector<ContactEvent>> events_;  ///< by unit
  std::vector<ContactMotion> motion_;              ///< [units][bins]
  std::vector<std::uint8_t> touched_;              ///< by place in the lists of batches
  SampleChoice choice_;
  ContactPicker picker_;
  Real strain_rate_ = 0;
  std::vector<std::vector<ContactSample>> samples_;   ///< by unit
  std::vector<std::vector<ContactPick>> picks_;       ///< by unit
  std::vector<std::vector<SampledContact>> sampled_;  ///< by batch
};

}  // namespace bagnold
