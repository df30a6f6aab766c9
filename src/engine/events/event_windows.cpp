// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_windows.hpp"

#include <algorithm>

namespace bagnold::events {

namespace {

/// Calls visit(i, the image of j) for all that touch at a time that has been reached, i < j.
template <bool Rotates, class Visit>
void for_each_touch(EventDisks<Rotates> const& disks, Real time, Visit const& visit) {
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& p = disks.path[i];
    if (p.manner == Manner::contact && p.straight > time) {
      if (auto const& c = disks.contacts[disks.touching[i]]; c.i == i) visit(i, c.other);
    } else if (p.manner == Manner::cluster) {
      auto const& cluster = disks.clusters[disks.touching[i]];
      for (auto const& link : cluster.links)
        if (cluster.members[link.a].disk == i) visit(i, link.other);
    }
  }
}

}  // namespace

template <bool Rotates>
void EventWindows<Rotates>::begin(Real time) {
  s_.sums.begin(time);
  s_.sums.speeds().clear();
  s_.sums.speeds().add(0, s_.times.speed());
  add_ahead(time, 1);
}

template <bool Rotates>
void EventWindows<Rotates>::end(Real time, Real* columns) {
  add_ahead(time, -1);
  auto const& disks = s_.disks;
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    if (disks.path[i].manner != Manner::cluster) {
      s_.sums.flight(i, time);
    } else if (auto const& cluster = disks.clusters[disks.touching[i]]; cluster.slot() == i) {
      s_.sums.step(cluster, std::min(time, cluster.end()));
    }
  }
  s_.sums.close(columns);
}

template <bool Rotates>
void EventWindows<Rotates>::recall_rates(std::int64_t begun, std::int64_t step) {
  auto& speeds = s_.sums.speeds();
  speeds.clear();
  for (auto from = begun; from <= step;) {
    auto const stretch = s_.times.rates().at(from);
    speeds.add(s_.times.between(begun, from), stretch.rate / s_.times.unit_rate());
    from = stretch.end;
  }
}

/// Adds the rest of open contacts, all of which is added when they begin.
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
std::vector<TouchingPair<Rotates>> touching_pairs(EventState<Rotates> const& state, Real time) {
  auto const& disks = state.disks;
  auto const& name = disks.name;
  std::vector<TouchingPair<Rotates>> all;
  auto const add = [&](std::uint32_t i, Neighbor n) {
    auto const j = n.index();
    auto const motion = pair_motion(disks.at(i, time), disks.image(disks.at(j, time), n, time));
    Real spin = 0;
    if constexpr (Rotates) {
      auto const& d = disks.material.table.diameter;
      Real const a = d[disks.path[i].species], b = d[disks.path[j].species];
      spin = (a * motion.spin_i + b * motion.spin_j) / (a + b);
    }
    all.push_back({std::min(name[i], name[j]), std::max(name[i], name[j]), motion, spin});
  };
  for_each_touch(disks, time, add);
  return all;
}

template class EventWindows<false>;
template class EventWindows<true>;
template std::vector<TouchingPair<false>> touching_pairs(EventState<false> const&, Real);
template std::vector<TouchingPair<true>> touching_pairs(EventState<true> const&, Real);

}  // namespace bagnold::events
