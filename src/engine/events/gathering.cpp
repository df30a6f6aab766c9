// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/gathering.hpp"

namespace bagnold::events {

template <bool Rotates>
void Gathering<Rotates>::take_in(std::uint32_t disk, Real time) {
  if (group.has(disk)) return;
  Path const& p = s_.disks.path[disk];
  if (p.manner == Manner::cluster) return take_cluster(s_.disks.touching[disk], time);
  if (time < p.straight) return take_contact(s_.disks.touching[disk], time);
  s_.sums.flight(disk, time);
  group.disks.push_back({disk, s_.disks.on_line(disk, time)});
}

template <bool Rotates>
void Gathering<Rotates>::take_contact(std::uint32_t k, Real time) {
  auto const& contact = s_.disks.contacts[k];
  auto const [first, second] = cut_short(s_, contact, time);
  group.disks.push_back({contact.i, first});
  group.disks.push_back({contact.j(), second});
  group.touches.push_back({contact.i, contact.other, contact.touched});
}

template <bool Rotates>
void Gathering<Rotates>::take_cluster(std::uint32_t k, Real time) {
  auto& cluster = s_.disks.clusters[k];
  bool const at_begin = !(time > cluster.time);
  if (!at_begin) s_.sums.step(cluster, time);
  for (auto const& m : cluster.members)
    group.disks.push_back({m.disk, at_begin ? m.begin : m.at(time - cluster.time)});
  for (auto const& link : cluster.links)
    group.touches.push_back({cluster.members[link.a].disk, link.other, link.touched});
  s_.disks.clusters.remove(k);
}

template class Gathering<false>;
template class Gathering<true>;

}  // namespace bagnold::events
