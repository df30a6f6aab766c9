// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "kernels/cpu/steps/block_step.hpp"
#include "kernels/cpu/contacts/contact_changes.hpp"
#include "kernels/cpu/islands/predict_contacts.hpp"
#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/contacts/contact_record.hpp"

namespace bagnold {

/// Sees the contacts of disks in blocks begin and end.
///
/// Which pairs were in contact a step before is kept for each place of the inner lists; where these
/// were taken anew, the record's table of open contacts says it, which knows nothing of lists.
class ContactWatch {
 public:
  /// The disks have other slots, or the inner lists hold other pairs.
  void rearranged() { arranged_ = listed_ = false; }
  void relisted() { listed_ = false; }

  /// What has begun or ended in the configuration at `step`, and its sums if it is sampled.
  template <class Step>
  void look(BlockLoop& loop, Step const& all, ShearedBox const& box, std::int64_t step,
            Sampling const& sampling, OpenWindows& windows) {
    auto const& blocks = all.blocks;
    ContactRecord& record = *windows.contacts;
    know_disks(blocks);
    if (!listed_) list(blocks, record.table);
    bool const sampled = sampling.sampled(step);
    found_.resize(blocks.count);
    picks_.resize(blocks.count);
    motion_.assign(blocks.count, {});
    ContactPicker const picker = record.picker();
    loop(blocks.count, [&](std::uint32_t b) {
      Block const& block = blocks.block(b);
      refresh_halo(blocks, block, all.now, box);
      auto const* const records = all.now.record.data() + block.first;
      contact_changes(
          blocks, block, records, touched_.data(),
          [&](simd::LocalPair const& pair, bool begins, Vec2<Real> const& separation,
              Vec2<Real> const& velocity) {
            auto const slots = slot_pair(blocks, block, pair);
            if (!is_first_listing(slots)) return;
            found_[b].push_back(contact_event(step, begins, disk(slots.a), disk(slots.b.index()),
                                              separation, velocity));
          });
      if (sampled)
        motion_[b] = contact_motion(
            blocks, block, records, touched_.data(),
            [&](int c, simd::LocalPair const& pair) { return all.common_spin(block, c, pair); },
            [&](simd::LocalPair const& pair, Vec2<Real> const& separation,
                Vec2<Real> const& velocity, Real spin) {
              auto const slots = slot_pair(blocks, block, pair);
              if (!is_first_listing(slots)) return;
              picker(picks_[b], step, disk(slots.a), disk(slots.b.index()), [&] {
                return contact_velocities(separation, velocity, spin, box.strain_rate);
              });
            });
    });
    for (auto& found : found_) take(found);
    for (auto& picks : picks_) record.add(picks);
    ContactMotion motion;
    for (auto const& of_block : motion_) motion += of_block;
    if (sampled) record.add(motion, step, sampling, windows);
    tell(sampling, windows);
    if (record.choice)
      for (auto const& contact : record.due(step)) {
        auto const pair = pair_now(all, box, contact);
        record.add(
            {step, contact.a, contact.b,
             contact_velocities(pair.separation, pair.velocity, pair.spin, box.strain_rate)});
      }
    record.looked(step, step + 1, sampling, windows);
  }

  /// Ends the contacts that are none any more in the configuration at `step`, wherever lists stand.
  template <class Step>
  void close_parted(Step const& all, ShearedBox const& box, std::int64_t step,
                    Sampling const& sampling, OpenWindows& windows) {
    know_disks(all.blocks);
    windows.contacts->table.each([&](OpenContact const& contact) {
      auto const pair = pair_now(all, box, contact);
      if (dot(pair.separation, pair.separation) < pair.distance * pair.distance) return;
      events_.push_back(
          contact_event(step, false, contact.a, contact.b, pair.separation, pair.velocity));
    });
    tell(sampling, windows);
  }

  /// The index at the start of the disk in a slot.
  std::uint32_t disk(std::uint32_t slot) const { return disk_of_[slot]; }

  /// Takes events to be told, and tells them.
  void take(std::vector<ContactEvent>& events) {
    events_.insert(events_.end(), events.begin(), events.end());
    events.clear();
  }
  void take(std::vector<ContactSample>& samples) {
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    samples.clear();
  }
  void tell(Sampling const& sampling, OpenWindows& windows) {
    windows.contacts->add(events_, samples_, sampling, windows);
  }

 private:
  struct PairNow {
    Vec2<Real> separation, velocity;
    Real distance;  ///< d_ij
    Real spin;      ///< see contact_velocities
  };

  /// Two disks and the nearest image of the second, wherever lists stand.
  template <class Step>
  static PairNow pair_now(Step const& all, ShearedBox const& box, OpenContact const& contact) {
    auto const a = all.blocks.slot_of(contact.a), b = all.blocks.slot_of(contact.b);
    auto const &p = all.now.record(a), &q = all.now.record(b);
    Image image;
    image.n = static_cast<int>(std::lround((p.y - q.y) / box.length));
    image.m = static_cast<int>(std::lround((p.x - q.x - image.n * box.offset) / box.length));
    auto const at = at_image(q, image, box);
    PairNow pair{{p.x - at.x, p.y - at.y},
                 {p.vx - at.vx, p.vy - at.vy},
                 class_distance(pair_class(all.species(a), all.species(b))),
                 0};
    if constexpr (Step::rotates) pair.spin = all.common_spin(a, b);
    return pair;
  }

  void know_disks(Blocks const& blocks) {
    if (arranged_) return;
    disk_of_.assign(blocks.slots, 0);
    for (std::uint32_t i = 0; i < blocks.slot_of.extent(0); ++i) disk_of_[blocks.slot_of(i)] = i;
    arranged_ = true;
  }

  void list(Blocks const& blocks, ContactTable const& table) {
    touched_.assign(blocks.outer.extent(0) / simd::width, 0);
    for (std::uint32_t b = 0; b < blocks.count; ++b) {
      Block const& block = blocks.block(b);
      fill_touched(blocks, block, touched_.data(), [&](simd::LocalPair const& pair) {
        auto const slots = slot_pair(blocks, block, pair);
        return table.is_open(disk(slots.a), disk(slots.b.index()));
      });
    }
    listed_ = true;
  }

  bool arranged_ = false;                         ///< disk_of_ is that of the blocks
  bool listed_ = false;                           ///< touched_ is that of the inner lists
  std::vector<std::uint32_t> disk_of_;            ///< by slot
  std::vector<std::uint8_t> touched_;             ///< a byte for eight places of the inner lists
  std::vector<std::vector<ContactEvent>> found_;  ///< by block
  std::vector<std::vector<ContactPick>> picks_;   ///< by block
  std::vector<ContactMotion> motion_;             ///< by block
  std::vector<ContactEvent> events_;
  std::vector<ContactSample> samples_;
};

}  // namespace bagnold
