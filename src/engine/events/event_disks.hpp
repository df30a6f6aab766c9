// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/cpu/events/cluster_steps.hpp"
#include "kernels/cpu/events/lone_contact.hpp"
#include "kernels/cpu/events/path.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "src/engine/events/contact_ring.hpp"
#include "src/engine/events/disk_order.hpp"
#include "src/engine/events/pool.hpp"

namespace bagnold::events {

/// thetadot of each disk on its line, [1 / tau_e].
template <bool Rotates>
struct Spins {
  explicit Spins(std::size_t) {}
  void take(std::uint32_t, Motion<false> const&) {}
  void give(std::uint32_t, Motion<false>&) const {}
  void reorder(std::vector<std::uint32_t> const&) {}
};

template <>
struct Spins<true> {
  std::vector<Real> value;
  explicit Spins(std::size_t disks) : value(disks) {}
  void take(std::uint32_t i, Motion<true> const& motion) { value[i] = motion.spin; }
  void give(std::uint32_t i, Motion<true>& motion) const { motion.spin = value[i]; }
  void reorder(std::vector<std::uint32_t> const& order) { value = in_order(value, order); }
};

/// Disks that are a part's own, and not of its halo; all disks where there are no parts.
struct OwnDisks {
  std::uint32_t first = 0, count = std::numeric_limits<std::uint32_t>::max();
};

/// All disks between two builds of the lists: their paths, and whom they touch.
template <bool Rotates>
class EventDisks {
 public:
  using Moving = DiskMotion<Rotates>;

  EventDisks(Material<Rotates> const& of, std::vector<Species> const& species,
             OwnDisks const& own = {});

  Material<Rotates> material;
  ImageShifts shifts;
  std::vector<Path> path;               ///< [N]
  Spins<Rotates> spin;                  ///< [N]
  std::vector<std::uint32_t> touching;  ///< [N], in `contacts` or `clusters`, by its manner
  std::vector<std::uint32_t> member;    ///< [N], in its cluster; of a lone contact: the other disk
  std::vector<std::uint32_t> name;      ///< [N], of the disk outside of this engine
  ContactRing<Rotates> contacts;        ///< of paths that are remembered
  Pool<Cluster<Rotates>> clusters;
  Real now = 0;  ///< up to which all has happened
  OwnDisks own;
  Real strain_rate = 0;  ///< of the box, [1 / tau_e]
  Real fastest = 0;      ///< bound of peculiar speeds so far, [d_s / tau_e]

  bool owns(std::uint32_t i) const { return i - own.first < own.count; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(path.size()); }
  Real mass(std::uint32_t i) const { return 1 / material.table.inverse_mass[path[i].species]; }

  ContactClass<Rotates> const& contact_class(LoneContact<Rotates> const& c) const {
    return material.classes(path[c.i].species, path[c.j()].species);
  }
  Real distance(std::uint32_t i, Neighbor n) const {
    return class_distance(pair_class(path[i].species, n.big() ? 1 : 0));
  }

  /// True if a disk touches nobody.
  bool flies(std::uint32_t i, Real time) const {
    return path[i].manner != Manner::cluster && time >= path[i].straight;
  }

  /// Peculiar speeds may come to that of a line through a position, and more.
  void note_speed(Vec2<Real> const& position, Vec2<Real> const& velocity, Real more = 0) {
    Real const u = peculiar_x(velocity.x, position.y, strain_rate);
    fastest = std::max(fastest, std::sqrt(u * u + velocity.y * velocity.y) + more);
  }
  void note_speed(LoneContact<Rotates> const& contact) {
    note_speed(contact.centre.position, contact.centre.velocity,
               contact.closed.largest_speed(contact_class(contact)));
  }
  void note_speeds(Cluster<Rotates> const& cluster) {
    for (auto const& m : cluster.members)
      note_speed(m.begin.position, m.begin.motion.velocity, m.acceleration * cluster.step);
  }

  /// Position and motion at a time of its path.
  Moving at(std::uint32_t i, Real time) const;
  Moving on_line(std::uint32_t i, Real time) const;

  /// Motion of an image of a disk.
  Moving image(Moving of, Neighbor n, Real time, Real sign = 1) const {
    auto const& shift = shifts(n);
    of.position += sign * shift.at(time);
    of.motion.velocity.x += sign * shift.velocity;
    return of;
  }

  /// Both disks of a lone contact, each in its own place.
  Moving first_of(LoneContact<Rotates> const& contact, Real time) const;
  Moving second_of(LoneContact<Rotates> const& contact, Real time) const;

  /// Bound of |r''| from a time of its path on, before its line begins, [d_s / tau_e^2].
  Real acceleration(std::uint32_t i, Real from) const;

  /// True if both paths begin with their contact.
  bool touch_each_other(std::uint32_t i, std::uint32_t j) const {
    return path[i].manner == Manner::contact && path[j].manner == Manner::contact &&
           member[i] == j && member[j] == i;
  }

  /// True if the contact that a path begins with may still be asked for at a time: by disks that
  /// came to touch others while it lasted.
  bool remembers(std::uint32_t i, Real time) const {
    return path[i].manner == Manner::contact && path[i].straight + material.remember >= time;
  }

  /// A contact that begins at a time, with which no path begins yet.
  std::uint32_t add_contact(Real time) { return contacts.add(time, material.remember); }

  /// The path of a disk begins with a contact.
  void hold_contact(std::uint32_t i, std::uint32_t k) {
    touching[i] = k;
    member[i] = i == contacts[k].i ? contacts[k].j() : contacts[k].i;
  }

  /// New paths: of a free disk, of both disks of contacts[k], of all disks of clusters[k].
  void fly(std::uint32_t i, Moving const& from, Real time);
  void begin_contact(std::uint32_t k);
  void begin_cluster(std::uint32_t k);

  /// Corridors for the disks of clusters[k] that would leave their own in its step.
  void begin_step(std::uint32_t k);

  /// Forgets a contact that has ended: the disk flies since.
  void forget_contact(std::uint32_t i);

  /// Gives each disk, with its contact or cluster, another place: order[k] is the present place of
  /// the disk that comes k-th. No contact may have ended.
  void reorder(std::vector<std::uint32_t> const& order);

 private:
  bool keeps_corridor(Cluster<Rotates> const& cluster, Member<Rotates> const& m) const;
  void set_contact(std::uint32_t i, std::uint32_t k, Moving const& end, Real deviation);
};

extern template class EventDisks<false>;
extern template class EventDisks<true>;

}  // namespace bagnold::events
