// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/events/flight_integrals.hpp"
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
      : disks_(&disks), inverse_step_(1 / time_step) {}

  Real strain_rate = 0;             ///< gammadot, [1 / tau_e]
  ContactMotion* motion = nullptr;  ///< where that of contacts is asked for

  /// From a time on everything is added to these columns.
  void begin(Real* columns, Real time) {
    to_ = columns;
    begin_ = time;
  }

  /// Of disk i on its line, which ends at a time, or is left there.
  void flight(std::uint32_t i, Real until) {
    Path const& p = disks_->path[i];
    Real const from = std::max(p.straight, begin_);
    if (!(until > from)) return;
    auto const of = disks_->on_line(i, from);
    add_flight<Rotates>(to_, disks_->mass(i), of.position, of.motion, strain_rate, until - from,
                        inverse_step_);
  }

  /// What is ahead of a contact from a time on, and the motion of both disks in it.
  void contact(LoneContact<Rotates> const& of, Real from, Real sign) {
    Real const s = from - of.begun;
    if (!(s < of.closed.duration)) return;
    ContactIntegrals<Rotates> const integrals{disks_->contact_class(of)};
    Real const weight = sign * inverse_step_;
    integrals.over(of.closed, s, of.closed.duration, [&](auto const& nodes) {
      nodes.add_pair_columns(to_, weight);
      nodes.add_motion_columns(to_, of.centre, disks_->mass(of.i), disks_->mass(of.j()),
                               strain_rate, weight);
      if (motion) nodes.add_contact_motion(*motion, weight);
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
           Real weight);

  EventDisks<Rotates> const* disks_;
  Real inverse_step_;
  Real* to_ = nullptr;
  Real begin_ = 0;
  std::vector<Node> nodes_;  ///< of the members of a cluster
};

extern template class EventSums<false>;
extern template class EventSums<true>;

}  // namespace bagnold::events
