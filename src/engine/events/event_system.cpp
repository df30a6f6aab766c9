// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_system.hpp"

#include <algorithm>
#include <limits>

#include "src/engine/events/frames.hpp"

namespace bagnold::events {

template <bool Rotates>
void EventSystem<Rotates>::place(std::vector<Moving> const& disks, ShearedBox const& box,
                                 std::int64_t step) {
  s_.times.count_from(step);
  s_.move_to(step);
  std::vector<Vec2<Real>> position;
  for (std::uint32_t i = 0; i < disks.size(); ++i) {
    s_.disks.fly(i, disks[i], 0);
    position.push_back(disks[i].position);
  }
  sort(position, box);
  build(position, box);
  predict_all();
}

template <bool Rotates>
void EventSystem<Rotates>::restore(Arrays const& from, std::vector<Vec2<Real>> const& list_position,
                                   ShearedBox const& box, std::int64_t list_step,
                                   std::int64_t step) {
  s_.times.count_from(list_step);
  s_.move_to(step);
  auto const order = saved_order(from);
  s_.disks.reorder(order);
  build(in_order(list_position, order), box);
  s_.disks.now = s_.times.time(step - list_step);
  events::restore(from, s_);
}

template <bool Rotates>
void EventSystem<Rotates>::sort(std::vector<Vec2<Real>>& position, ShearedBox const& box) {
  auto const order = order_along_curve(position, box);
  s_.disks.reorder(order);
  position = in_order(position, order);
}

template <bool Rotates>
void EventSystem<Rotates>::build(std::vector<Vec2<Real>> const& position, ShearedBox const& box) {
  auto const& disks = s_.disks;
  std::vector<Species> species(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) species[i] = disks.path[i].species;
  s_.disks.shifts = ImageShifts(box);
  s_.lists.build(position, species, disks.material.table, box,
                 blocks_ ? &blocks_->threads() : nullptr);
  s_.disks.strain_rate = s_.sums.strain_rate = box.strain_rate;
  s_.build_step = s_.times.last_within(s_.lists.longest());
  if (blocks_) blocks_->forget();
}

template <bool Rotates>
void EventSystem<Rotates>::find_touches() {
  constexpr Real ever = -std::numeric_limits<Real>::infinity();
  auto const& disks = s_.disks;
  TouchingGroup<Rotates> group(disks.count());
  std::vector<bool> taken(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    for (auto k = s_.lists.begin(i); k < s_.lists.end(i); ++k) {
      Neighbor const n = s_.lists.entry(k);
      auto const j = n.index();
      if (j < i) continue;
      auto const r = disks.path[i].at(0) - disks.path[j].at(0) - disks.shifts(n).at(0);
      Real const d = disks.distance(i, n);
      if (!(dot(r, r) < d * d)) continue;
      group.touches.push_back({i, n, ever});
      s_.log.begins(disks.name[i], disks.name[j], 0, r, r);
      taken[i] = taken[j] = true;
    }
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    if (taken[i]) group.disks.push_back({i, disks.on_line(i, 0)});
  loop_.touches.settle(group, 0);
  if (blocks_) blocks_->look_again();
}

template <bool Rotates>
void EventSystem<Rotates>::watch_contacts(Real time) {
  if (by_blocks()) loop_.predict_all();  // no blocks report contacts
  s_.log.on = true;
  s_.sums.motion = &s_.log.motion;
  auto& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    if (p.manner != Manner::contact || p.straight <= time) continue;
    if (auto& contact = disks.contacts[disks.touching[i]]; contact.i == i)
      loop_.touches.expect_end(contact);
  }
}

template <bool Rotates>
std::int64_t EventSystem<Rotates>::run(std::int64_t step) {
  Real const until = s_.times.time(step);
  if (by_blocks())
    blocks_->run(until);
  else
    loop_.run(until);
  auto const reached = std::min(step, s_.build_step);
  return s_.too_deep ? std::min(reached, s_.times.step_at(s_.disks.now)) : reached;
}

/// Calls of_contact(contact, its number) and of_cluster(cluster, its number) for all that touch at
/// a time, by disk.
template <bool Rotates>
template <class OfContact, class OfCluster>
void EventSystem<Rotates>::for_each_under_way(Real time, OfContact const& of_contact,
                                              OfCluster const& of_cluster) {
  auto& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    auto const k = disks.touching[i];
    if (p.manner == Manner::contact && p.straight > time) {
      if (auto& contact = disks.contacts[k]; contact.i == i) of_contact(contact, k);
    } else if (p.manner == Manner::cluster) {
      if (auto& cluster = disks.clusters[k]; cluster.slot() == i) of_cluster(cluster, k);
    }
  }
}

/// Disks whose contacts have ended fly on from the end: all of these, which are to be predicted
/// anew.
template <bool Rotates>
std::vector<std::uint32_t> EventSystem<Rotates>::forget_ended_contacts(Real time) {
  auto& disks = s_.disks;
  std::vector<std::uint32_t> forgotten;
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    if (disks.path[i].manner == Manner::contact && disks.path[i].straight <= time) {
      disks.forget_contact(i);
      forgotten.push_back(i);
    }
  return forgotten;
}

template <bool Rotates>
void EventSystem<Rotates>::change_rate(std::int64_t step) {
  Real const time = s_.times.time(step - s_.times.counted_from());
  auto slots = forget_ended_contacts(time);  // their constants will not be known
  std::vector<std::pair<Moving, Moving>> pairs;
  for_each_under_way(
      time,
      [&](LoneContact<Rotates> const& contact, std::uint32_t) {
        pairs.push_back(cut_short(s_, contact, time));
      },
      [&](Cluster<Rotates>& cluster, std::uint32_t) {
        s_.sums.step(cluster, time);
        for (auto& m : cluster.members) {
          m.begin = m.at(time - cluster.time);
          ++s_.disks.path[m.disk].changes;  // touches in the rest of the step are stale
        }
        cluster.time = time;
      });
  s_.move_to(step);
  s_.disks.now = std::max(s_.disks.now, time);
  auto pair = pairs.cbegin();
  for_each_under_way(
      time,
      [&](LoneContact<Rotates>& contact, std::uint32_t k) {
        ++s_.counts.carried_contacts;
        loop_.touches.solve(contact, pair->first, pair->second, false, time);
        ++pair;
        s_.disks.begin_contact(k);
        slots.insert(slots.end(), {contact.i, contact.j()});
      },
      [&](Cluster<Rotates>& cluster, std::uint32_t k) {
        loop_.touches.plan(k);
        slots.push_back(cluster.slot());
      });
  if (by_blocks()) return blocks_->look_again();
  for (auto const slot : slots) loop_.predict(slot);
}

template <bool Rotates>
void EventSystem<Rotates>::renew(std::int64_t step, ShearedBox const& box, bool sorted) {
  auto& disks = s_.disks;
  Real const time = s_.times.time(step - s_.times.counted_from());
  s_.times.count_from(step);
  Frames<Rotates> frames(disks, s_.lists.box(), box, time);
  std::vector<std::uint32_t> clusters;
  forget_ended_contacts(time);
  for_each_under_way(
      time, [&](LoneContact<Rotates>& contact, std::uint32_t) { frames.move(contact); },
      [&](Cluster<Rotates>& cluster, std::uint32_t k) {
        frames.move(cluster);
        clusters.push_back(k);
      });
  disks.contacts.shift(time);
  for (std::uint32_t i = 0; i < disks.count(); ++i) frames.move(i, disks.path[i]);
  disks.now = 0;
  s_.log.shift(time);
  auto position = frames.position();
  if (sorted) sort(position, box);
  build(position, box);
  for (auto const k : clusters) loop_.touches.plan(k);
  predict_all();
}

template class EventSystem<false>;
template class EventSystem<true>;

}  // namespace bagnold::events
