// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kernels/cpu/events/flight_integrals.hpp"
#include "kernels/cpu/events/speeds.hpp"
#include "kernels/physics/closed_form/contact_integrals.hpp"
#include "src/engine/events/event_disks.hpp"

namespace bagnold::events {

/// Integrals over time of all columns of SumColumns, over the time step: sums over as many
/// configurations as there are steps. Flights and contacts of two in closed form, steps of clusters
/// by Gauss's rule. What a disk does is added when it changes, or the window ends; the
/// contact of two is added whole when it begins, and what lies ahead is taken back where it is cut
/// short.
///
/// Groups of as many disks, in their order in memory, have sums of their own, which are added up in
/// this order: so no bit depends on which groups go together. A contact counts with its disk i.
template <bool Rotates>
class EventSums {
 public:
  using Columns = std::array<Real, Sums<Rotates>::columns>;

  EventSums(EventDisks<Rotates> const& disks, Real time_step, std::uint32_t group)
      : disks_(&disks),
        inverse_step_(1 / time_step),
        group_(group),
        groups_((disks.own.count + group - 1) / group) {
    set_speed(1);
  }

  Real strain_rate = 0;             ///< gammadot, [1 / tau_e]
  ContactMotion* motion = nullptr;  ///< where that of contacts is asked for

  /// From a time on everything is added up.
  void begin(Real time) {
    open_ = true;
    begin_ = time;
  }
  /// Gives all of it to these columns, and adds nothing any more.
  void close(Real* columns) {
    for (auto& group : groups_) {
      for (std::size_t c = 0; c < group.size(); ++c) columns[c] += group[c];
      group = {};
    }
    open_ = false;
  }

  bool open() const { return open_; }
  std::uint32_t group() const { return group_; }  ///< disks in one

  /// Sums of the window under way, by group of own disks.
  std::vector<Columns>& groups() { return groups_; }
  std::vector<Columns> const& groups() const { return groups_; }

  /// Goes on from sums of all groups, the own ones from one on.
  void follow(EventSums const& all, std::uint32_t first) {
    strain_rate = all.strain_rate;
    open_ = all.open_;
    begin_ = all.begin_;
    speeds_ = all.speeds_;
    set_speed(all.speed_);
    std::copy_n(all.groups_.begin() + first, groups_.size(), groups_.begin());
  }

  /// gammadot/gammadot_0 from now on, in which time and motion are counted.
  void set_speed(Real speed);
  /// Speeds in the window under way, each from a time since its begin on.
  Speeds& speeds() { return speeds_; }

  /// Adds the flight of disk i on its line, which ends at a time, or is left there.
  void flight(std::uint32_t i, Real until) {
    Path const& p = disks_->path[i];
    Real const from = std::max(p.straight, begin_);
    Real* const to = sums_of(i);
    if (!(until > from) || !to) return;
    auto const of = disks_->on_line(i, from);
    if (speeds_.change())
      add_flight<Rotates>(to, disks_->mass(i) / (speed_ * speed_), of.position, of.motion,
                          strain_rate, speeds_.between(from - begin_, until - begin_),
                          inverse_step_);
    else
      add_flight<Rotates>(to, disks_->mass(i), of.position, of.motion, strain_rate, until - from,
                          inverse_step_);
  }

  /// Adds the rest of a contact from a time on, and the motion of both disks in it.
  void contact(LoneContact<Rotates> const& of, Real from, Real sign) {
    Real const s = from - of.begun;
    Real* const columns = sums_of(of.i);
    if (!(s < of.closed.duration) || !columns) return;
    ContactIntegrals<Rotates> const integrals{disks_->contact_class(of)};
    Real const weight = sign * inverse_step_ / speed_;
    in_units(columns, [&](Real* to, ContactMotion* of_motion) {
      integrals.over(of.closed, s, of.closed.duration, [&](auto const& nodes) {
        nodes.add_pair_columns(to, weight);
        nodes.add_motion_columns(to, of.centre, disks_->mass(of.i), disks_->mass(of.j()),
                                 strain_rate, weight);
        if (of_motion) nodes.add_contact_motion(*of_motion, weight);
      });
    });
  }

  /// The step of a cluster up to a time.
  void step(Cluster<Rotates> const& cluster, Real until);

 private:
  /// A disk of a cluster at the nodes of a part of its step.
  struct Node {
    Vec2<AtNodes> position, velocity;
    AtNodes spin{0.0};
  };

  /// Where own disk i is added up, or none.
  Real* sums_of(std::uint32_t i) {
    if (!open_ || !disks_->owns(i)) return nullptr;
    return groups_[(i - disks_->own.first) / group_].data();
  }

  void add_members(Real* columns, Cluster<Rotates> const& cluster, AtNodes const& time,
                   Real weight);
  void add(AtNodes* columns, Cluster<Rotates> const& cluster, Link const& link, AtNodes const& time,
           Real weight, ContactMotion* of_motion);

  /// Calls add(columns, motion or none), and takes what it adds to units of tau_e.
  template <class Add>
  void in_units(Real* to, Add const& add) {
    if (speed_ == 1) return add(to, motion);
    Real columns[Sums<Rotates>::columns] = {};
    ContactMotion of_motion{};
    add(columns, motion ? &of_motion : nullptr);
    for (int c = 0; c < Sums<Rotates>::columns; ++c) to[c] += unit_[c] * columns[c];
    if (!motion) return;
    for (int c = 0; c < ContactMotion::count; ++c)
      motion->value[c] += unit_of_motion_[c] * of_motion.value[c];
  }

  EventDisks<Rotates> const* disks_;
  Real inverse_step_;
  std::uint32_t group_;
  std::vector<Columns> groups_;  ///< of own disks
  bool open_ = false;
  Real begin_ = 0;
  Real speed_ = 1;
  Real unit_[SumColumns::count_rotating], unit_of_motion_[ContactMotion::count];
  Speeds speeds_;
  std::vector<Node> nodes_;  ///< of the members of a cluster
};

extern template class EventSums<false>;
extern template class EventSums<true>;

}  // namespace bagnold::events
