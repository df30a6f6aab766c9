// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/saved_events.hpp"

#include "src/config/errors.hpp"
#include "src/engine/events/saved_values.hpp"

namespace bagnold::events {

namespace {

constexpr char disks_name[] = "events_paths", contacts_name[] = "events_lone_contacts",
               clusters_name[] = "events_clusters", order_name[] = "events_order",
               sums_name[] = "events_sums";

std::vector<double> const& array(Arrays const& from, std::string const& name) {
  auto const found = from.find(name);
  if (found == from.end())
    throw InputError("the checkpoint lacks " + name + ", which this engine goes on from");
  return found->second;
}

}  // namespace

template <bool Rotates>
Arrays save(EventState<Rotates> const& state, Real time) {
  auto const& disks = state.disks;
  Arrays arrays;
  arrays[order_name].assign(disks.name.begin(), disks.name.end());
  Write disk{arrays[disks_name]}, contact{arrays[contacts_name]}, cluster{arrays[clusters_name]};
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& path = disks.path[i];
    visit_path(disk, path);
    disk(static_cast<int>(path.manner));
    if constexpr (Rotates) disk(disks.spin.value[i]);
    auto const other = path.manner == Manner::contact ? disks.member[i] : i;
    disk(other);
    bool const written = other < i && disks.touch_each_other(i, other);
    if (disks.remembers(i, time) && !written)
      visit_contact<Rotates>(contact, disks.contacts[disks.touching[i]]);
    if (path.manner != Manner::cluster) continue;
    auto const& of = disks.clusters[disks.touching[i]];
    if (of.slot() != i) continue;
    cluster(of.time);
    cluster(of.members.size());
    cluster(of.links.size());
    for (auto const& m : of.members) {
      cluster(m.disk);
      visit_moving<Rotates>(cluster, m.begin);
    }
    for (auto const& link : of.links) visit_link(cluster, link);
  }
  if (state.sums.open())
    for (auto const& group : state.sums.groups())
      arrays[sums_name].insert(arrays[sums_name].end(), group.begin(), group.end());
  return arrays;
}

std::vector<std::uint32_t> saved_order(Arrays const& from) {
  auto const& order = array(from, order_name);
  return {order.begin(), order.end()};
}

template <bool Rotates>
void restore(Arrays const& from, EventState<Rotates>& state) {
  auto& disks = state.disks;
  Read disk{array(from, disks_name)}, contact{array(from, contacts_name)},
      cluster{array(from, clusters_name)};
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path& path = disks.path[i];
    visit_path(disk, path);
    path.manner = static_cast<Manner>(static_cast<int>(disk.take()));
    if constexpr (Rotates) disk(disks.spin.value[i]);
    disk(disks.member[i]);
  }
  while (!contact.done()) {
    auto const k = disks.add_contact(-never);
    auto& of = disks.contacts[k];
    visit_contact<Rotates>(contact, of);
    of.solve(disks.contact_class(of));
    auto const hold = [&](std::uint32_t i, std::uint32_t other) {
      Path const& path = disks.path[i];
      if (path.manner == Manner::contact && path.begun == of.begun && disks.member[i] == other)
        disks.hold_contact(i, k);
    };
    hold(of.i, of.j());
    hold(of.j(), of.i);
  }
  while (!cluster.done()) {
    auto const k = disks.clusters.add();
    auto& of = disks.clusters[k];
    cluster(of.time);
    auto const members = static_cast<std::size_t>(cluster.take());
    auto const links = static_cast<std::size_t>(cluster.take());
    of.members.resize(members);
    of.links.resize(links);
    for (auto& m : of.members) {
      cluster(m.disk);
      visit_moving<Rotates>(cluster, m.begin);
      m.species = disks.path[m.disk].species;
    }
    for (auto& link : of.links) visit_link(cluster, link);
    disks.begin_cluster(k);
    state.steps.plan(of);
    disks.begin_step(k);
  }
  if (!from.contains(sums_name)) return;
  Read sums{array(from, sums_name)};
  for (auto& group : state.sums.groups())
    for (Real& value : group) sums(value);
}

template Arrays save(EventState<false> const&, Real);
template Arrays save(EventState<true> const&, Real);
template void restore(Arrays const&, EventState<false>&);
template void restore(Arrays const&, EventState<true>&);

}  // namespace bagnold::events
