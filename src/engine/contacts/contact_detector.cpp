// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/contacts/contact_detector.hpp"

#include <cmath>

#include "kernels/cpu/contacts/contact_changes.hpp"
#include "kernels/cpu/islands/predict_contacts.hpp"

namespace bagnold {

namespace {

struct PairNow {
  Vec2<Real> separation, velocity;
  Real distance;  ///< d_ij
  Real spin;      ///< see contact_velocities
};

/// Two disks and the nearest image of the second, wherever lists stand.
PairNow pair_now(BlockSystem const& all, ShearedBox const& box, OpenContact const& contact) {
  auto const a = all.blocks.slot_of(contact.a), b = all.blocks.slot_of(contact.b);
  auto const &p = all.now.record(a), &q = all.now.record(b);
  Image image;
  image.n = static_cast<int>(std::lround((p.y - q.y) / box.height));
  image.m = static_cast<int>(std::lround((p.x - q.x - image.n * box.offset) / box.length));
  auto const at = at_image(q, image, box);
  return {{p.x - at.x, p.y - at.y},
          {p.vx - at.vx, p.vy - at.vy},
          class_distance(pair_class(all.species(a), all.species(b))),
          all.common_spin(a, b)};
}

}  // namespace

void ContactDetector::detect(BlockLoop& loop, BlockSystem const& all, ShearedBox const& box,
                             std::int64_t step, Sampling const& sampling, OpenWindows& windows) {
  auto const& blocks = all.blocks;
  ContactRecord& record = *windows.contacts;
  know_disks(all);
  if (listing_ != all.listing) list(all, record.table);
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
          [&](simd::LocalPair const& pair, Vec2<Real> const& separation, Vec2<Real> const& velocity,
              Real spin) {
            auto const slots = slot_pair(blocks, block, pair);
            if (!is_first_listing(slots)) return;
            picker(picks_[b], step, disk(slots.a), disk(slots.b.index()),
                   [&] { return contact_velocities(separation, velocity, spin, box.strain_rate); });
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
      record.add({step, contact.a, contact.b,
                  contact_velocities(pair.separation, pair.velocity, pair.spin, box.strain_rate)});
    }
  record.evaluated(step, step + 1, sampling, windows);
}

void ContactDetector::close_parted(BlockSystem const& all, ShearedBox const& box, std::int64_t step,
                                   Sampling const& sampling, OpenWindows& windows) {
  know_disks(all);
  windows.contacts->table.each([&](OpenContact const& contact) {
    auto const pair = pair_now(all, box, contact);
    if (dot(pair.separation, pair.separation) < pair.distance * pair.distance) return;
    events_.push_back(
        contact_event(step, false, contact.a, contact.b, pair.separation, pair.velocity));
  });
  tell(sampling, windows);
}

void ContactDetector::take(std::vector<ContactEvent>& events) {
  events_.insert(events_.end(), events.begin(), events.end());
  events.clear();
}

void ContactDetector::take(std::vector<ContactSample>& samples) {
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  samples.clear();
}

void ContactDetector::tell(Sampling const& sampling, OpenWindows& windows) {
  windows.contacts->add(events_, samples_, sampling, windows);
}

void ContactDetector::know_disks(BlockSystem const& all) {
  if (arrangement_ == all.arrangement) return;
  auto const& slot_of = all.blocks.slot_of;
  disk_of_.assign(all.blocks.slots, 0);
  for (std::uint32_t i = 0; i < slot_of.extent(0); ++i) disk_of_[slot_of(i)] = i;
  arrangement_ = all.arrangement;
}

void ContactDetector::list(BlockSystem const& all, ContactTable const& table) {
  auto const& blocks = all.blocks;
  touched_.assign(blocks.outer.extent(0) / simd::width, 0);
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block const& block = blocks.block(b);
    fill_touched(blocks, block, touched_.data(), [&](simd::LocalPair const& pair) {
      auto const slots = slot_pair(blocks, block, pair);
      return table.is_open(disk(slots.a), disk(slots.b.index()));
    });
  }
  listing_ = all.listing;
}

}  // namespace bagnold
