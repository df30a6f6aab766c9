// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/cpu/events/series.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/closed_form/contact_class.hpp"

namespace bagnold::events {

/// Series of a spin, of a law that has one.
template <bool Rotates>
struct SpinSeries {};

template <>
struct SpinSeries<true> {
  Series spin;  ///< thetadot, [1 / tau_e]
};

/// A disk of a cluster, and how it moves in one step: by Taylor series from its begin on.
template <bool Rotates>
struct Member : SpinSeries<Rotates> {
  std::uint32_t disk;
  Species species;
  DiskMotion<Rotates> begin;
  Series x, y;        ///< [d_s]
  Real acceleration;  ///< bound of |r''| over the step, [d_s / tau_e^2]
  Real deviation;     ///< bound of the distance from the line of its begin, [d_s]
  bool strays;        ///< it has left its corridor

  template <class T>
  Vec2<T> position(T const& s) const {
    return {value(x, s), value(y, s)};
  }
  template <class T>
  Vec2<T> velocity(T const& s) const {
    return {rate(x, s), rate(y, s)};
  }
  DiskMotion<Rotates> at(Real s) const {
    DiskMotion<Rotates> of{position(s), {}};
    of.motion.velocity = velocity(s);
    if constexpr (Rotates) of.motion.spin = value(this->spin, s);
    return of;
  }

  void bound(Real step) {
    acceleration = second_rate_bound(x, y, step);
    deviation = acceleration * step * step / 2;
  }
};

/// A contact between two members of a cluster.
struct Link {
  std::uint32_t a, b;  ///< members
  Neighbor other;      ///< the image of b that a touches
  Real touched;        ///< when it began, [tau_e]; -infinity: it was there at the start
};

/// Disks joined by contacts, three at least, which are stepped together.
template <bool Rotates>
struct Cluster {
  Real time = 0;                         ///< at which the step begins, [tau_e]
  Real step = 0;                         ///< how long it is
  int ending = -1;                       ///< the link that parts at its end; -1: none
  std::vector<Member<Rotates>> members;  ///< by disk when it began
  std::vector<Link> links;

  Real end() const { return time + step; }
  std::uint32_t slot() const { return members.front().disk; }  ///< in the queue

  /// Member index of a disk, in a cluster that has just been made.
  std::uint32_t member(std::uint32_t disk) const {
    auto const found = std::ranges::lower_bound(members, disk, {}, &Member<Rotates>::disk);
    return static_cast<std::uint32_t>(found - members.begin());
  }
  bool linked(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::any_of(
        links, [&](Link const& l) { return (l.a == a && l.b == b) || (l.a == b && l.b == a); });
  }
};

}  // namespace bagnold::events
