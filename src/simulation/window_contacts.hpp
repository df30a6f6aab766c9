// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/islands/lane_watch.hpp"
#include "kernels/islands/sample_times.hpp"
#include "src/simulation/contact_watch.hpp"

namespace bagnold {

/// The contacts of a window of steps, kept by unit (what is done at one go) until it is known which
/// units count.
class WindowContacts {
 public:
  /// Before a window, when all contacts of the configurations before it have been told; first
  /// closes those that have parted in its own first one, which no unit may see.
  template <class Step>
  void begin(ContactWatch& watch, Step const& all, ShearedBox const& box, std::int64_t step,
             Sampling const& sampling, OpenWindows& windows) {
    on_ = windows.contacts != nullptr;
    if (!on_) return;
    for (auto& events : events_) events.clear();
    motion_.clear();
    units_ = 0;
    begin_ = step;
    watch.close_parted(all, box, step, sampling, windows);
    watch_ = &watch;
    table_ = &windows.contacts->table;
  }

  explicit operator bool() const { return on_; }

  /// bins: measurement windows.
  void add_unit(std::size_t bins) {
    ++units_;
    bins_ = bins;
    if (events_.size() < units_) events_.emplace_back();
    motion_.resize(units_ * bins);
  }

  /// A pair of slots, as a unit, is to be lane k.
  void set_lane(LaneWatch& lanes, int k, std::size_t unit, std::uint32_t slot_a,
                std::uint32_t slot_b) {
    lanes.begin = begin_;
    lanes.lane[k] = {watch_->disk(slot_a), watch_->disk(slot_b), &events_[unit],
                     motion_.data() + unit * bins_};
    if (open(slot_a, slot_b)) lanes.touched |= 1u << k;
  }

  /// Batches as blocks; slot(b, local): where a disk of one is among all.
  template <class Slot>
  void list_batches(Blocks const& blocks, Slot const& slot) {
    touched_.assign(blocks.block(blocks.count - 1).pairs[pair_classes] / simd::width, 0);
    for (std::uint32_t b = 0; b < blocks.count; ++b)
      fill_touched(blocks, blocks.block(b), touched_.data(), [&](simd::LocalPair const& pair) {
        return open(slot(b, pair.a()), slot(b, pair.b()));
      });
  }

  /// What begins or ends in batch b after `steps` steps of the window.
  template <class Slot>
  void look(Blocks const& blocks, std::uint32_t b, simd::Record const* records, std::size_t unit,
            std::int64_t steps, Slot const& slot) {
    Block const& block = blocks.block(b);
    contact_changes(blocks, block, records + block.first, touched_.data(),
                    [&](simd::LocalPair const& pair, bool begins, Vec2<Real> const& separation,
                        Vec2<Real> const& velocity) {
                      events_[unit].push_back(
                          contact_event(begin_ + steps, begins, watch_->disk(slot(b, pair.a())),
                                        watch_->disk(slot(b, pair.b())), separation, velocity));
                    });
  }

  /// Adds a batch's sums to a measurement window.
  void sample(Blocks const& blocks, std::uint32_t b, simd::Record const* records, std::size_t unit,
              std::size_t bin) {
    Block const& block = blocks.block(b);
    motion_[unit * bins_ + bin] +=
        contact_motion(blocks, block, records + block.first, touched_.data());
  }

  /// After a window that counts: tells of the units for which counts(unit) holds.
  template <class Counts>
  void tell(std::int64_t end, SampleTimes const& times, Sampling const& sampling,
            OpenWindows& windows, Counts const& counts) {
    ContactRecord const& record = *windows.contacts;
    std::vector<ContactMotion> motion(times.bins());
    for (std::size_t unit = 0; unit < units_; ++unit) {
      if (!counts(unit)) continue;
      watch_->take(events_[unit]);
      for (std::size_t bin = 0; bin < times.bins(); ++bin)
        motion[bin] += motion_[unit * bins_ + bin];
    }
    watch_->tell(sampling, windows);
    auto const first = sampling.window(begin_);
    for (std::size_t bin = 0; bin < times.bins(); ++bin)
      record.add(motion[bin], first + static_cast<std::int64_t>(bin), windows);
    record.looked(begin_, end, sampling, windows);
  }

 private:
  bool open(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return table_->is_open(watch_->disk(slot_a), watch_->disk(slot_b));
  }

  bool on_ = false;
  ContactWatch* watch_ = nullptr;
  ContactTable const* table_ = nullptr;
  std::int64_t begin_ = 0;  ///< of the window, [steps]
  std::size_t units_ = 0, bins_ = 0;
  std::vector<std::vector<ContactEvent>> events_;  ///< by unit
  std::vector<ContactMotion> motion_;              ///< [units][bins]
  std::vector<std::uint8_t> touched_;              ///< by place in the lists of batches
};

}  // namespace bagnold
