// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/saved_events.hpp"

#include "src/config/errors.hpp"
#include "src/engine/events/saved_values.hpp"

namespace bagnold::events {

namespace {

constexpr char disks_name[] = "events_disks", contacts_name[] = "events_contacts",
               clusters_name[] = "events_clusters", order_name[] = "events_order";

std::vector<double> const& array(Arrays const& from, std::string const& name) {
  auto const found = from.find(name);
  if (found == from.end())
    throw InputError("the checkpoint lacks " + name + ", which this engine goes on from");
  return found->second;
}

}  // namespace

template <bool Rotates>
Arrays save(EventDisks<Rotates> const& disks) {
  Arrays arrays;
  arrays[order_name].assign(disks.name.begin(), disks.name.end());
  Write disk{arrays[disks_name]}, contact{arrays[contacts_name]}, cluster{arrays[clusters_name]};
  std::map<std::uint32_t, std::uint32_t> number;  // of contacts
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path const& path = disks.path[i];
    visit_path(disk, path);
    disk(static_cast<int>(path.manner));
    if constexpr (Rotates) disk(disks.spin.value[i]);
    if (path.manner != Manner::contact) {
      disk(0);
    } else {
      auto const [place, is_new] =
          number.try_emplace(disks.touching[i], static_cast<std::uint32_t>(number.size()));
      if (is_new) visit_contact<Rotates>(contact, disks.contacts[place->first]);
      disk(place->second);
    }
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
  std::vector<std::uint32_t> contacts;
  std::vector<std::uint32_t> number(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    Path& path = disks.path[i];
    visit_path(disk, path);
    path.manner = static_cast<Manner>(static_cast<int>(disk.take()));
    if constexpr (Rotates) disk(disks.spin.value[i]);
    disk(number[i]);
  }
  while (!contact.done()) {
    auto const k = disks.add_contact();
    auto& of = disks.contacts[k];
    visit_contact<Rotates>(contact, of);
    of.solve(disks.contact_class(of));
    contacts.push_back(k);
  }
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    if (disks.path[i].manner != Manner::contact) continue;
    disks.hold_contact(i, contacts.at(number[i]));
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
}

template Arrays save(EventDisks<false> const&);
template Arrays save(EventDisks<true> const&);
template void restore(Arrays const&, EventState<false>&);
template void restore(Arrays const&, EventState<true>&);

}  // namespace bagnold::events
