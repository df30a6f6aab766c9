// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/saved_events.hpp"

#include "src/config/errors.hpp"

namespace bagnold::events {

namespace {

/// Numbers one after the other, written or read in one order.
struct Write {
  std::vector<double>& to;

  template <class Value>
  void operator()(Value const& value) {
    to.push_back(static_cast<double>(value));
  }
};

struct Read {
  std::vector<double> const& from;
  std::size_t next = 0;

  bool done() const { return next == from.size(); }
  double take() {
    if (done()) throw InputError("the checkpoint lacks events: it is damaged");
    return from[next++];
  }
  template <class Value>
  void operator()(Value& value) {
    value = static_cast<Value>(take());
  }
};

template <class Visit, class Vector>
void visit_vector(Visit& visit, Vector& v) {
  visit(v.x);
  visit(v.y);
}

template <bool Rotates, class Visit, class Moving>
void visit_moving(Visit& visit, Moving& of) {
  visit_vector(visit, of.position);
  visit_vector(visit, of.motion.velocity);
  if constexpr (Rotates) visit(of.motion.spin);
}

template <class Visit, class P>
void visit_path(Visit& visit, P& path) {
  visit_vector(visit, path.place);
  visit_vector(visit, path.velocity);
  visit(path.begun);
  visit(path.straight);
  visit(path.deviation);
}

template <bool Rotates, class Visit, class Contact>
void visit_contact(Visit& visit, Contact& contact) {
  visit(contact.i);
  visit(contact.other.packed);
  visit(contact.fresh);
  visit(contact.binary);
  visit(contact.begun);
  visit(contact.touched);
  visit_vector(visit, contact.start.separation);
  visit_vector(visit, contact.start.velocity);
  if constexpr (Rotates) {
    visit(contact.start.spin_i);
    visit(contact.start.spin_j);
  }
  visit_vector(visit, contact.centre.position);
  visit_vector(visit, contact.centre.velocity);
}

template <class Visit, class L>
void visit_link(Visit& visit, L& link) {
  visit(link.a);
  visit(link.b);
  visit(link.other.packed);
  visit(link.touched);
}

constexpr char disks_name[] = "events_disks", contacts_name[] = "events_contacts",
               clusters_name[] = "events_clusters";

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
    auto const k = disks.contacts.add();
    auto& of = disks.contacts[k];
    visit_contact<Rotates>(contact, of);
    of.paths = 0;
    of.solve(disks.contact_class(of));
    contacts.push_back(k);
  }
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    if (disks.path[i].manner != Manner::contact) continue;
    disks.touching[i] = contacts.at(number[i]);
    ++disks.contacts[disks.touching[i]].paths;
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
