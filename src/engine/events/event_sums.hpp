// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
template <bool Rotates>
class EventSums {
 public:
  EventSums(EventDisks<Rotates> const& disks, Real time_step)
      : disks_(&disks), inverse_step_(1 / time_step) {
    set_speed(1);
  }

  Real strain_rate = 0;             ///< gammadot, [1 / tau_e]
  ContactMotion* motion = nullptr;  ///< where that of contacts is asked for

  /// From a time on everything is added to these columns.
  void begin(Real* columns, Real time) {
    to_ = columns;
    begin_ = time;
  }
  /// Nothing is added any more.
  void close() { to_ = nullptr; }

  /// gammadot/gammadot_0 from now on, in which time and motion are counted.
  void set_speed(Real speed);
  /// Speeds in the window under way, each from a time since its begin on.
  Speeds& speeds() { return speeds_; }

  /// Of disk i on its line, which ends at a time, or is left there.
  void flight(std::uint32_t i, Real until) {
    Path const& p = disks_->path[i];
    Real const from = std::max(p.straight, begin_);
    if (!(until > from) || !to_) return;
    auto const of = disks_->on_line(i, from);
    if (speeds_.change())
      add_flight<Rotates>(to_, disks_->mass(i) / (speed_ * speed_), of.position, of.motion,
                          strain_rate, speeds_.between(from - begin_, until - begin_),
                          inverse_step_);
    else
      add_flight<Rotates>(to_, disks_->mass(i), of.position, of.motion, strain_rate, until - from,
                          inverse_step_);
  }

  /// What is ahead of a contact from a time on, and the motion of both disks in it.
  void contact(LoneContact<Rotates> const& of, Real from, Real sign) {
    Real const s = from - of.begun;
    if (!(s < of.closed.duration) || !to_) return;
    ContactIntegrals<Rotates> const integrals{disks_->contact_class(of)};
    Real const weight = sign * inverse_step_ / speed_;
    in_units([&](Real* to, ContactMotion* of_motion) {
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

  void add(AtNodes* columns, Cluster<Rotates> const& cluster, Link const& link, AtNodes const& time,
           Real weight, ContactMotion* of_motion);

  /// Calls add(columns, motion or none), and takes what it adds to units of tau_e.
  template <class Add>
  void in_units(Add const& add) {
    if (speed_ == 1) return add(to_, motion);
    Real columns[Sums<Rotates>::columns] = {};
    ContactMotion of_motion{};
    add(columns, motion ? &of_motion : nullptr);
    for (int c = 0; c < Sums<Rotates>::columns; ++c) to_[c] += unit_[c] * columns[c];
    if (!motion) return;
    for (int c = 0; c < ContactMotion::count; ++c)
      motion->value[c] += unit_of_motion_[c] * of_motion.value[c];
  }

  EventDisks<Rotates> const* disks_;
  Real inverse_step_;
  Real* to_ = nullptr;
  Real begin_ = 0;
  Real speed_ = 1;
  Real unit_[SumColumns::count_rotating], unit_of_motion_[ContactMotion::count];
  Speeds speeds_;
  std::vector<Node> nodes_;  ///< of the members of a cluster
};

extern template class EventSums<false>;
extern template class EventSums<true>;

}  // namespace bagnold::events
