// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_windows.hpp"

#include <algorithm>

namespace bagnold::events {

template <bool Rotates>
void EventWindows<Rotates>::begin(Real* columns, Real time) {
  s_.sums.begin(columns, time);
  add_ahead(time, 1);
}

template <bool Rotates>
void EventWindows<Rotates>::end(Real time) {
  add_ahead(time, -1);
  auto const& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    if (disks.path[i].manner != Manner::cluster) {
      s_.sums.flight(i, time);
    } else if (auto const& cluster = disks.clusters[disks.touching[i]]; cluster.slot() == i) {
      s_.sums.step(cluster, std::min(time, cluster.end()));
    }
  }
}

/// What is yet to come of contacts, all of which is added when they begin.
template <bool Rotates>
void EventWindows<Rotates>::add_ahead(Real time, Real sign) {
  auto const& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    if (p.manner != Manner::contact || p.straight <= time) continue;
    auto const& contact = disks.contacts[disks.touching[i]];
    if (contact.i == i) s_.sums.contact(contact, time, sign);
  }
}

template <bool Rotates>
std::vector<std::pair<std::uint32_t, std::uint32_t>> who_touches(EventDisks<Rotates> const& disks,
                                                                 Real time) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    if (p.manner == Manner::contact && p.straight > time) {
      if (auto const& c = disks.contacts[disks.touching[i]]; c.i == i) all.push_back({i, c.j()});
    } else if (p.manner == Manner::cluster) {
      auto const& cluster = disks.clusters[disks.touching[i]];
      for (auto const& link : cluster.links)
        if (cluster.members[link.a].disk == i) all.push_back({i, link.other.index()});
    }
  }
  return all;
}

template class EventWindows<false>;
template class EventWindows<true>;
template TouchingPairs who_touches(EventDisks<false> const&, Real);
template TouchingPairs who_touches(EventDisks<true> const&, Real);

}  // namespace bagnold::events
