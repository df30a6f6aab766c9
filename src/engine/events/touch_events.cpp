// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/touch_events.hpp"

#include <tuple>

namespace bagnold::events {

template <bool Rotates>
void TouchEvents<Rotates>::touch(std::uint32_t i, Neighbor n, Real time) {
  auto const j = n.index();
  if (j < i) {
    n = seen_from_other(i, s_.disks.path[i].species != 0, n);
    i = j;
  }
  bool const counts = s_.disks.owns(i);
  s_.counts.collisions += counts;
  if (s_.disks.flies(i, time) && s_.disks.flies(n.index(), time)) return begin_lone(i, n, time);
  s_.counts.busy_collisions += counts;
  auto& group = gathering_.group;
  group.clear();
  gathering_.take_in(i, time);
  gathering_.take_in(n.index(), time);
  group.touches.push_back({i, n, time});
  if (s_.log.on) {
    auto const pair = pair_motion(group.of(i), s_.disks.image(group.of(n.index()), n, time));
    s_.log.begins(name(i), name(n.index()), time, pair.separation, pair.velocity);
  }
  settle(group, time);
}

template <bool Rotates>
void TouchEvents<Rotates>::begin_lone(std::uint32_t i, Neighbor n, Real time) {
  auto const j = n.index();
  s_.sums.flight(i, time);
  s_.sums.flight(j, time);
  auto const k =
      add_contact(s_.disks.on_line(i, time), s_.disks.on_line(j, time), {i, n, time}, true, time);
  auto const& start = s_.disks.contacts[k].start;
  s_.log.begins(name(i), name(j), time, start.separation, start.velocity);
  s_.disks.begin_contact(k);
  s_.predictions.of_disk(i);
  s_.predictions.of_disk(j);
}

template <bool Rotates>
void TouchEvents<Rotates>::expect_end(LoneContact<Rotates>& contact) {
  auto const& end = contact.closed.end;
  contact.number = s_.log.expect_end(name(contact.i), name(contact.j()), contact.end(),
                                     end.separation, end.velocity);
}

template <bool Rotates>
std::uint32_t TouchEvents<Rotates>::add_contact(Moving const& a, Moving const& b,
                                                Touch const& touch, bool fresh, Real time) {
  auto const k = s_.disks.add_contact(time);
  auto& contact = s_.disks.contacts[k];
  contact.i = touch.i;
  contact.other = touch.other;
  contact.binary = fresh;
  contact.touched = touch.touched;
  solve(contact, a, b, fresh, time);
  return k;
}

template <bool Rotates>
void TouchEvents<Rotates>::solve(LoneContact<Rotates>& contact, Moving const& a, Moving const& b,
                                 bool fresh, Real time) {
  contact.fresh = fresh;
  contact.begun = time;
  auto const& c = s_.disks.contact_class(contact);
  auto const image = s_.disks.image(b, contact.other, time);
  contact.start = pair_motion(a, image);
  contact.centre = c.centre(a, image);
  contact.solve(c);
  s_.sums.contact(contact, time, 1);
  expect_end(contact);
  auto const relative = [&](Real overlap) { return overlap * c.inverse_distance; };
  if (!(relative(contact.closed.largest_overlap()) <= largest_relative_overlap))  // else by a bound
    s_.check_overlap(contact.i, relative(contact.closed.deepest_overlap(c)));
}

/// New paths for all of a group, by what hangs together in it, and what happens to them next.
template <bool Rotates>
void TouchEvents<Rotates>::settle(Group& group, Real time) {
  auto const& parts = group.parts();
  auto& clusters = clusters_;
  clusters.clear();
  for (auto const& part : parts) {
    if (part.disks.size() == 1) {
      s_.disks.fly(part.disks[0].disk, part.disks[0].motion, time);
    } else if (part.disks.size() == 2) {
      auto const& touch = part.touches[0];
      auto const& [low, high] = std::tie(part.disks[0].motion, part.disks[1].motion);
      bool const in_order = touch.i < touch.j();  // not where disks changed places in memory
      s_.disks.begin_contact(add_contact(in_order ? low : high, in_order ? high : low, touch,
                                         touch.touched == time, time));
    } else {
      clusters.push_back(add_cluster(part, time));
    }
  }
  for (auto const k : clusters) plan(k);
  auto cluster = clusters.begin();
  for (auto const& part : parts) {
    if (part.disks.size() > 2) {
      for (auto const& d : part.disks) s_.queue.clear(d.disk);
      s_.predictions.of_cluster(*cluster++);
    } else {
      for (auto const& d : part.disks) s_.predictions.of_disk(d.disk);
    }
  }
}

template <bool Rotates>
std::uint32_t TouchEvents<Rotates>::add_cluster(typename Group::Part const& part, Real time) {
  auto const k = s_.disks.clusters.add();
  auto& cluster = s_.disks.clusters[k];
  cluster.time = time;
  cluster.members.clear();
  cluster.links.clear();
  for (auto const& d : part.disks) {
    auto& m = cluster.members.emplace_back();
    m.disk = d.disk;
    m.species = s_.disks.path[d.disk].species;
    m.begin = d.motion;
  }
  for (auto const& t : part.touches)
    cluster.links.push_back({cluster.member(t.i), cluster.member(t.j()), t.other, t.touched});
  s_.disks.begin_cluster(k);
  return k;
}

template <bool Rotates>
void TouchEvents<Rotates>::plan(std::uint32_t k) {
  auto& cluster = s_.disks.clusters[k];
  s_.steps.plan(cluster);
  s_.counts.cluster_steps += s_.disks.owns(cluster.slot());
  s_.disks.begin_step(k);
  for (auto const& m : cluster.members)
    if (!s_.lists.within_reach(m.disk, m.position(cluster.step), {}, cluster.end()))
      s_.ask_for_build(m.disk, cluster.end());
  for (std::size_t n = 0; n < cluster.links.size(); ++n)
    s_.check_overlap(cluster.members[cluster.links[n].a].disk,
                     s_.steps.relative_overlap(cluster, n));
}

template <bool Rotates>
void TouchEvents<Rotates>::end_step(std::uint32_t k) {
  auto& cluster = s_.disks.clusters[k];
  Real const time = cluster.end();
  if (cluster.ending < 0) {
    s_.sums.step(cluster, time);
    for (auto& m : cluster.members) m.begin = m.at(cluster.step);
    cluster.time = time;
    plan(k);
    return s_.predictions.of_cluster(k);
  }
  auto const parted = cluster.links[static_cast<std::size_t>(cluster.ending)];
  auto const i = cluster.members[parted.a].disk;
  s_.log.ends(name(i), name(parted.other.index()), time,
              s_.steps.separation(cluster, parted, cluster.step),
              s_.steps.velocity(cluster, parted, cluster.step));
  auto& group = gathering_.group;
  group.clear();
  gathering_.take_cluster(k, time);
  std::erase_if(group.touches,
                [&](auto const& t) { return t.i == i && t.other.packed == parted.other.packed; });
  settle(group, time);
}

template class TouchEvents<false>;
template class TouchEvents<true>;

}  // namespace bagnold::events
