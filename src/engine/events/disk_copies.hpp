// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

#include "src/engine/events/event_disks.hpp"
#include "src/engine/events/event_part.hpp"

/// Disks of a system and of a part of it, which hold the same paths, contacts and clusters by other
/// indices. place(i): of disk i there, or none; both keep the order of disks.
namespace bagnold::events {

template <bool Rotates>
bool same_bits(DiskMotion<Rotates> const& a, DiskMotion<Rotates> const& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// True if disk i of a and disk j of b are the same to the last bit, with what they touch. in_a(i),
/// in_b(j): what both call them.
template <bool Rotates, class InA, class InB>
bool same_disk(EventDisks<Rotates> const& a, std::uint32_t i, InA const& in_a,
               EventDisks<Rotates> const& b, std::uint32_t j, InB const& in_b) {
  Path const &p = a.path[i], &q = b.path[j];
  if (std::memcmp(&p, &q, sizeof p) != 0) return false;
  if constexpr (Rotates)
    if (std::memcmp(&a.spin.value[i], &b.spin.value[j], sizeof(Real)) != 0) return false;
  if (p.manner == Manner::contact) {
    auto const k = in_a(a.member[i]), l = in_b(b.member[j]);
    return k == l || k == Part::none || l == Part::none;  // a partner beyond the halo is not known
  }
  if (p.manner == Manner::free) return true;
  auto const &one = a.clusters[a.touching[i]], &other = b.clusters[b.touching[j]];
  return one.time == other.time && one.members.size() == other.members.size() &&
         same_bits(one.members[a.member[i]].begin, other.members[b.member[j]].begin);
}

/// Path of a disk that touches nobody, or of whose contact no more than its partner is remembered.
template <bool Rotates, class Place>
void copy_path(EventDisks<Rotates> const& from, std::uint32_t i, EventDisks<Rotates>& to,
               std::uint32_t j, Place const& place) {
  to.path[j] = from.path[i];
  if constexpr (Rotates) to.spin.value[j] = from.spin.value[i];
  if (to.path[j].manner == Manner::contact) to.member[j] = place(from.member[i]);
}

/// The contact with which the path of disk i begins, both of whose disks are there, to path j.
template <bool Rotates, class Place>
void copy_contact(EventDisks<Rotates> const& from, std::uint32_t i, EventDisks<Rotates>& to,
                  std::uint32_t j, Place const& place) {
  auto contact = from.contacts[from.touching[i]];
  auto const n = contact.other;
  contact.other = Neighbor::make(place(n.index()), n.image(), n.big());
  contact.i = place(contact.i);
  auto const k = to.add_contact(to.now);
  to.contacts[k] = contact;
  to.touching[j] = k;
  auto const other = to.member[j];
  if (to.touch_each_other(j, other) && to.path[other].begun == to.path[j].begun)
    to.touching[other] = k;
}

/// A cluster all of whose disks are there, with their paths.
template <bool Rotates, class Place>
void copy_cluster(EventDisks<Rotates> const& from, Cluster<Rotates> const& cluster,
                  EventDisks<Rotates>& to, Place const& place) {
  auto const k = to.clusters.add();
  auto& copy = to.clusters[k];
  copy = cluster;
  for (std::uint32_t a = 0; a < copy.members.size(); ++a) {
    auto& m = copy.members[a];
    auto const j = place(m.disk);
    copy_path(from, m.disk, to, j, place);
    to.touching[j] = k;
    to.member[j] = a;
    m.disk = j;
  }
  for (auto& link : copy.links)
    link.other = Neighbor::make(place(link.other.index()), link.other.image(), link.other.big());
}

}  // namespace bagnold::events
