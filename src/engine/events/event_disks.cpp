// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_disks.hpp"

#include <algorithm>
#include <numeric>

namespace bagnold::events {

template <bool Rotates>
EventDisks<Rotates>::EventDisks(Material<Rotates> const& of, std::vector<Species> const& species,
                                OwnDisks const& which)
    : material(of),
      path(species.size()),
      spin(species.size()),
      touching(species.size()),
      member(species.size()),
      name(species.size()),
      own{which.first, std::min(which.count, static_cast<std::uint32_t>(species.size()))} {
  std::iota(name.begin(), name.end(), std::uint32_t{0});
  for (std::size_t i = 0; i < species.size(); ++i) path[i].species = species[i];
}

template <bool Rotates>
auto EventDisks<Rotates>::on_line(std::uint32_t i, Real time) const -> Moving {
  Moving of{path[i].at(time), {}};
  of.motion.velocity = path[i].velocity;
  spin.give(i, of.motion);
  return of;
}

template <bool Rotates>
auto EventDisks<Rotates>::first_of(LoneContact<Rotates> const& k, Real time) const -> Moving {
  auto const& c = contact_class(k);
  return c.disk_i(k.centre_at(time), k.closed.at(c, time - k.begun));
}

template <bool Rotates>
auto EventDisks<Rotates>::second_of(LoneContact<Rotates> const& k, Real time) const -> Moving {
  auto const& c = contact_class(k);
  return image(c.disk_j(k.centre_at(time), k.closed.at(c, time - k.begun)), k.other, time, -1);
}

template <bool Rotates>
auto EventDisks<Rotates>::at(std::uint32_t i, Real time) const -> Moving {
  Path const& p = path[i];
  if (p.manner == Manner::cluster) {
    auto const& cluster = clusters[touching[i]];
    return cluster.members[member[i]].at(time - cluster.time);
  }
  if (time >= p.straight) return on_line(i, time);
  auto const& contact = contacts[touching[i]];
  return i == contact.i ? first_of(contact, time) : second_of(contact, time);
}

template <bool Rotates>
Real EventDisks<Rotates>::acceleration(std::uint32_t i, Real from) const {
  Path const& p = path[i];
  if (p.manner == Manner::cluster) return clusters[touching[i]].members[member[i]].acceleration;
  if (from >= p.straight) return 0;
  auto const& contact = contacts[touching[i]];
  auto const& c = contact_class(contact);
  return (i == contact.i ? c.share_i : c.share_j) * contact.closed.largest_acceleration(c);
}

template <bool Rotates>
void EventDisks<Rotates>::forget_contact(std::uint32_t i) {
  Path& p = path[i];
  ++p.changes;
  p.manner = Manner::free;
  p.begun = p.straight;
  p.deviation = 0;
}

template <bool Rotates>
void EventDisks<Rotates>::fly(std::uint32_t i, Moving const& from, Real time) {
  Path& p = path[i];
  ++p.changes;
  p.manner = Manner::free;
  p.fly(from.position, from.motion.velocity, time);
  p.begun = p.straight = time;
  p.deviation = 0;
  spin.take(i, from.motion);
  note_speed(from.position, from.motion.velocity);
}

template <bool Rotates>
void EventDisks<Rotates>::set_contact(std::uint32_t i, std::uint32_t k, Moving const& end,
                                      Real deviation) {
  auto const& contact = contacts[k];
  Path& p = path[i];
  ++p.changes;
  p.manner = Manner::contact;
  hold_contact(i, k);
  p.begun = contact.begun;
  p.straight = contact.end();
  p.fly(end.position, end.motion.velocity, p.straight);
  p.deviation = deviation;
  spin.take(i, end.motion);
}

template <bool Rotates>
void EventDisks<Rotates>::begin_contact(std::uint32_t k) {
  auto const& contact = contacts[k];
  auto const& c = contact_class(contact);
  auto const end = contact.end();
  note_speed(contact);
  auto const centre = contact.centre_at(end);
  Real const deviation = contact.closed.largest_deviation(c);
  auto const first = c.disk_i(centre, contact.closed.end);
  auto const second = image(c.disk_j(centre, contact.closed.end), contact.other, end, -1);
  set_contact(contact.i, k, first, c.share_i * deviation);
  set_contact(contact.j(), k, second, c.share_j * deviation);
}

template <bool Rotates>
void EventDisks<Rotates>::begin_cluster(std::uint32_t k) {
  auto const& members = clusters[k].members;
  for (std::uint32_t a = 0; a < members.size(); ++a) {
    auto const i = members[a].disk;
    Path& p = path[i];
    ++p.changes;
    if (p.manner != Manner::cluster) p.straight = p.deviation = 0;  // no corridor yet
    p.manner = Manner::cluster;
    touching[i] = k;
    member[i] = a;
  }
}

template <bool Rotates>
bool EventDisks<Rotates>::keeps_corridor(Cluster<Rotates> const& cluster,
                                         Member<Rotates> const& m) const {
  Path const& p = path[m.disk];
  Real const end = cluster.end(), left = p.deviation - m.deviation;
  auto const off = m.position(cluster.step) - p.at(end);
  return end <= p.straight && left > 0 && dot(off, off) < left * left;
}

template <bool Rotates>
void EventDisks<Rotates>::begin_step(std::uint32_t k) {
  constexpr Real steps = 8;   // longest ones, for which a corridor is made
  constexpr Real wide = 1.5;  // over what the speeds of the begin would need
  auto& cluster = clusters[k];
  note_speeds(cluster);
  Vec2<Real> mean{};
  for (auto const& m : cluster.members) mean += m.begin.motion.velocity;
  mean = (Real(1) / static_cast<Real>(cluster.members.size())) * mean;
  Real fastest2 = 0;
  for (auto& m : cluster.members) {
    m.strays = !keeps_corridor(cluster, m);
    auto const v = m.begin.motion.velocity - mean;
    fastest2 = std::max(fastest2, dot(v, v));
  }
  Real const time = steps * material.longest_step, width = wide * time * std::sqrt(fastest2);
  for (auto const& m : cluster.members) {
    if (!m.strays) continue;
    Path& p = path[m.disk];
    ++p.changes;
    p.begun = cluster.time;
    p.straight = cluster.time + time;
    p.fly(m.begin.position, mean, p.begun);
    p.deviation = width + 2 * m.deviation;
  }
}

template <bool Rotates>
void EventDisks<Rotates>::reorder(std::vector<std::uint32_t> const& order) {
  std::vector<std::uint32_t> place(count());
  for (std::uint32_t k = 0; k < count(); ++k) place[order[k]] = k;
  auto const moved = [&](Neighbor n) {
    return Neighbor::make(place[n.index()], n.image(), n.big());
  };
  std::vector<std::uint32_t> of_contacts;
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (path[i].manner == Manner::contact) {
      member[i] = place[member[i]];
      if (contacts[touching[i]].i == i) of_contacts.push_back(touching[i]);
    } else if (path[i].manner == Manner::cluster && member[i] == 0) {
      auto& cluster = clusters[touching[i]];
      for (auto& m : cluster.members) m.disk = place[m.disk];
      for (auto& link : cluster.links) link.other = moved(link.other);
    }
  }
  for (auto const k : of_contacts) {
    auto& contact = contacts[k];
    contact.i = place[contact.i];
    contact.other = moved(contact.other);
  }
  path = in_order(path, order);
  spin.reorder(order);
  touching = in_order(touching, order);
  member = in_order(member, order);
  name = in_order(name, order);
}

template class EventDisks<false>;
template class EventDisks<true>;

}  // namespace bagnold::events
