// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_system.hpp"

#include <algorithm>
#include <limits>

#include "src/engine/events/frames.hpp"

namespace bagnold::events {

template <bool Rotates>
void EventSystem<Rotates>::place(std::vector<Moving> const& disks, ShearedBox const& box) {
  std::vector<Vec2<Real>> position;
  for (std::uint32_t i = 0; i < disks.size(); ++i) {
    s_.disks.fly(i, disks[i], 0);
    position.push_back(disks[i].position);
  }
  build(std::move(position), box);
  predict_all();
}

template <bool Rotates>
void EventSystem<Rotates>::restore(Arrays const& from, std::vector<Vec2<Real>> list_position,
                                   ShearedBox const& box) {
  build(std::move(list_position), box);
  events::restore(from, s_);
}

template <bool Rotates>
void EventSystem<Rotates>::build(std::vector<Vec2<Real>> position, ShearedBox const& box) {
  auto const& disks = s_.disks;
  std::vector<Species> species(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) species[i] = disks.path[i].species;
  s_.disks.shifts = ImageShifts(box);
  s_.lists.build(std::move(position), species, disks.material.table, box);
  s_.sums.strain_rate = box.strain_rate;
  s_.predictions.watch_reach = true;
  Real const longest = s_.lists.longest() / (box.strain_rate * s_.time_step);
  s_.build_step = longest < 1e18 ? std::max<std::int64_t>(1, static_cast<std::int64_t>(longest))
                                 : std::numeric_limits<std::int64_t>::max() / 4;
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
      s_.log.begins(i, j, 0, r, r);
      taken[i] = taken[j] = true;
    }
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    if (taken[i]) group.disks.push_back({i, disks.on_line(i, 0)});
  touches_.settle(group, 0);
}

template <bool Rotates>
void EventSystem<Rotates>::watch_contacts(Real time) {
  s_.log.on = true;
  s_.sums.motion = &s_.log.motion;
  auto& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    if (p.manner != Manner::contact || p.straight <= time) continue;
    if (auto& contact = disks.contacts[disks.touching[i]]; contact.i == i)
      touches_.expect_end(contact);
  }
}

template <bool Rotates>
std::int64_t EventSystem<Rotates>::run(std::int64_t step) {
  auto const& times = s_.queue.times;
  while (!s_.too_deep) {
    auto const slot = times.first();
    Real const time = times.time(slot);
    if (time > s_.time(std::min(step, s_.build_step))) break;
    s_.now = std::max(s_.now, time);
    Event const event = s_.queue.event[slot];
    switch (event.kind) {
      case Event::Kind::leave:
        s_.ask_for_build(s_.now);
        predict(slot);
        break;
      case Event::Kind::end:
        touches_.end_step(s_.disks.touching[slot]);
        break;
      case Event::Kind::touch:
        if (auto const n = s_.lists.entry(event.entry);
            s_.disks.path[n.index()].changes == event.changes)
          touches_.touch(event.disk, n, time);
        else
          predict(slot);
    }
  }
  return std::min(step, s_.build_step);
}

template <bool Rotates>
void EventSystem<Rotates>::predict(std::uint32_t slot) {
  if (s_.disks.path[slot].manner == Manner::cluster)
    s_.predictions.of_cluster(s_.disks.touching[slot]);
  else
    s_.predictions.of_disk(slot);
}

template <bool Rotates>
void EventSystem<Rotates>::predict_all() {
  auto const& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    if (disks.path[i].manner == Manner::cluster) s_.predictions.find_near(i);
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    bool const follows =
        disks.path[i].manner == Manner::cluster && disks.clusters[disks.touching[i]].slot() != i;
    if (follows)
      s_.queue.set(i, never, {i});
    else
      predict(i);
  }
}

template <bool Rotates>
void EventSystem<Rotates>::renew(Real time, ShearedBox const& box) {
  auto& disks = s_.disks;
  Frames<Rotates> frames(disks, s_.lists.box(), box, time);
  std::vector<std::uint32_t> clusters;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path& p = disks.path[i];
    if (p.manner == Manner::contact && p.straight <= time) disks.forget_contact(i);
    if (p.manner == Manner::contact && disks.contacts[disks.touching[i]].i == i)
      frames.move(disks.contacts[disks.touching[i]]);
    if (p.manner == Manner::cluster && disks.clusters[disks.touching[i]].slot() == i) {
      frames.move(disks.clusters[disks.touching[i]]);
      clusters.push_back(disks.touching[i]);
    }
  }
  for (std::uint32_t i = 0; i < disks.count(); ++i) frames.move(i, disks.path[i]);
  s_.now = 0;
  s_.log.shift(time);
  build(frames.position(), box);
  for (auto const k : clusters) touches_.plan(k);
  predict_all();
}

template class EventSystem<false>;
template class EventSystem<true>;

}  // namespace bagnold::events
