// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_block.hpp"

#include <algorithm>
#include <utility>

#include "kernels/cpu/events/prefetch.hpp"
#include "src/engine/events/disk_copies.hpp"

namespace bagnold::events {

namespace {

template <bool Rotates>
std::vector<Species> part_species(EventDisks<Rotates> const& disks, Part const& part) {
  std::vector<Species> species;
  for (auto const i : part.of_whole) species.push_back(disks.path[i].species);
  return species;
}

}  // namespace

template <bool Rotates>
EventBlock<Rotates>::EventBlock(EventState<Rotates> const& whole, Part part)
    : whole_(whole),
      part_(std::move(part)),
      s_(whole.at_first_rate, part_species(whole.disks, part_), whole.lists.skin(), whole.times,
         whole.sums.group(), {part_.own_first, part_.count}),
      loop_(s_),
      marked_(part_.of_whole.size()),
      changes_(part_.count) {
  s_.disks.shifts = whole.disks.shifts;
  s_.disks.strain_rate = whole.disks.strain_rate;
  s_.lists.take(whole.lists, part_.of_whole);
}

template <bool Rotates>
void EventBlock<Rotates>::begin(bool own_too) {
  prefetch_all(s_.disks.path);
  s_.lists.fetch();
  prefetch_all(s_.queue.event);
  s_.disks.now = whole_.disks.now;
  s_.build_step = whole_.build_step;
  s_.too_deep.reset();
  cut_ = false;
  s_.counts = {};
  s_.sums.follow(whole_.sums, part_.first / s_.sums.group());
  own_too = own_too || std::exchange(new_, false);
  if (own_too) {
    s_.times = whole_.times;
    s_.disks.material = whole_.disks.material;
  }
  differ_.clear();
  auto const count = s_.disks.count();
  auto const look = [&](std::uint32_t first, std::uint32_t last) {
    for (auto k = first; k < last; ++k)
      if (!same_disk(
              whole_.disks, part_.of_whole[k], [](std::uint32_t i) { return i; }, s_.disks, k,
              [&](std::uint32_t m) { return part_.in_whole(m); }))
        mark(k);
  };
  if (own_too) {
    look(0, count);
  } else {
    look(0, own_first());
    look(own_end(), count);
  }
  renew();
  loop_.watch_again();
  for (std::uint32_t k = 0; k < part_.count; ++k)
    changes_[k] = s_.disks.path[own_first() + k].changes;
}

/// With all that are in one cluster with it, here or in the whole.
template <bool Rotates>
void EventBlock<Rotates>::mark(std::uint32_t k) {
  if (marked_[k]) return;
  marked_[k] = true;
  differ_.push_back(k);
  if (s_.disks.path[k].manner == Manner::cluster)
    for (auto const& m : s_.disks.clusters[s_.disks.touching[k]].members) mark(m.disk);
  auto const& whole = whole_.disks;
  auto const i = part_.of_whole[k];
  if (whole.path[i].manner == Manner::cluster)
    for (auto const& m : whole.clusters[whole.touching[i]].members)
      if (auto const other = part_.place(m.disk); other != Part::none) mark(other);
}

/// Takes all that differ from the whole, and predicts what happens to them, and to others with
/// them.
template <bool Rotates>
void EventBlock<Rotates>::renew() {
  auto& disks = s_.disks;
  for (auto const k : differ_)
    if (disks.path[k].manner == Manner::cluster)
      if (auto const c = disks.touching[k]; disks.clusters[c].slot() == k) disks.clusters.remove(c);
  for (auto const k : differ_) take(k);
  for (auto const k : differ_)
    if (disks.path[k].manner == Manner::cluster) s_.predictions.find_near(k);
  for (auto const k : differ_) {
    if (loop_.follows(k))
      s_.queue.set(k, never, {k});
    else
      loop_.predict(k);
  }
  if (!differ_.empty())
    for (std::uint32_t k = 0; k < disks.count(); ++k) {
      auto const& event = s_.queue.event[k];
      if (event.kind == Event::Kind::touch && marked_[event.other.index()] && !marked_[k])
        loop_.predict(k);
    }
  for (auto const k : differ_) marked_[k] = false;
}

/// A disk of the whole that touches one beyond the halo flies on: what becomes of it is not known.
template <bool Rotates>
void EventBlock<Rotates>::take(std::uint32_t k) {
  auto const& whole = whole_.disks;
  auto& disks = s_.disks;
  auto const i = part_.of_whole[k];
  auto const place = [&](std::uint32_t disk) { return part_.place(disk); };
  auto const fly = [&] {
    cut_ = cut_ || disks.owns(k);
    disks.path[k].manner = Manner::free;
    disks.fly(k, whole.at(i, disks.now), disks.now);
  };
  if (whole.path[i].manner == Manner::cluster) {
    auto const& cluster = whole.clusters[whole.touching[i]];
    bool const whole_here = std::ranges::all_of(
        cluster.members, [&](auto const& m) { return place(m.disk) != Part::none; });
    if (!whole_here) return fly();
    if (cluster.slot() != i) return;
    copy_cluster(whole, cluster, disks, place);
    return disks.note_speeds(cluster);
  }
  bool const remembered = whole.remembers(i, disks.now);
  if (remembered && place(whole.member[i]) == Part::none) return fly();
  copy_path(whole, i, disks, k, place);
  Path const& path = disks.path[k];
  disks.note_speed(path.at(path.straight), path.velocity);
  if (!remembered) return;
  copy_contact(whole, i, disks, k, place);
  disks.note_speed(disks.contacts[disks.touching[k]]);
}

template <bool Rotates>
Real EventBlock<Rotates>::leaves() const {
  Real first = never;
  for (auto k = own_first(); k < own_end(); ++k)
    if (s_.queue.event[k].kind == Event::Kind::leave)
      first = std::min(first, s_.queue.times.time(k));
  return first;
}

template <bool Rotates>
bool EventBlock<Rotates>::same_as_in(EventBlock const& owner, std::uint32_t k) const {
  return same_disk(
      s_.disks, k, [&](std::uint32_t i) { return part_.in_whole(i); }, owner.s_.disks,
      owner.part_.place(part_.of_whole[k]),
      [&](std::uint32_t j) { return owner.part_.in_whole(j); });
}

/// True if a disk of the halo, as it is here or in its own block, could come to touch an own disk
/// in the window that has been gone through: by where they were at its begin and by the largest
/// speeds. The mean flow differs by less than gammadot 6 d_s between two in one list.
template <bool Rotates>
bool EventBlock<Rotates>::may_be_met(EventBlock const& owner, std::uint32_t k, Real window) const {
  auto const& disks = s_.disks;
  Real const rate = disks.strain_rate, time = whole_.disks.now;
  Real const speed = disks.fastest + std::max(disks.fastest, owner.s_.disks.fastest) + 6 * rate;
  Real const way = speed * window * (1 + 2 * rate * window);
  auto const at_begin = [&](std::uint32_t disk) {
    return whole_.disks.at(part_.of_whole[disk], time).position;
  };
  auto const from = at_begin(k);
  for (auto e = s_.lists.begin(k); e < s_.lists.end(k); ++e) {
    Neighbor const n = s_.lists.entry(e);
    if (!disks.owns(n.index())) continue;
    auto const r = from - at_begin(n.index()) - disks.shifts(n).at(time);
    Real const touch = disks.distance(k, n) + way;
    if (dot(r, r) < touch * touch) return true;
  }
  return false;
}

template <bool Rotates>
void EventBlock<Rotates>::give_paths(EventState<Rotates>& whole) {
  auto const& disks = s_.disks;
  contacts_.clear();
  clusters_.clear();
  for (auto k = own_first(); k < own_end(); ++k) {
    Path const& path = disks.path[k];
    if (path.manner == Manner::cluster && disks.clusters[disks.touching[k]].slot() == k)
      clusters_.push_back(k);
    if (path.changes == changes_[k - own_first()]) continue;
    copy_path(disks, k, whole.disks, part_.of_whole[k],
              [&](std::uint32_t other) { return part_.in_whole(other); });
    if (disks.remembers(k, disks.now)) contacts_.push_back(k);
  }
}

template <bool Rotates>
void EventBlock<Rotates>::give_rest(EventState<Rotates>& whole) const {
  auto const place = [&](std::uint32_t k) { return part_.in_whole(k); };
  for (auto const k : contacts_) copy_contact(s_.disks, k, whole.disks, part_.of_whole[k], place);
  for (auto const k : clusters_)
    copy_cluster(s_.disks, s_.disks.clusters[s_.disks.touching[k]], whole.disks, place);
  std::ranges::copy(s_.sums.groups(), whole.sums.groups().begin() + part_.first / s_.sums.group());
  whole.counts += s_.counts;
  whole.build_step = std::min(whole.build_step, s_.build_step);
}

template class EventBlock<false>;
template class EventBlock<true>;

}  // namespace bagnold::events
