// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/closed_form/contact_class.hpp"

namespace bagnold::events {

/// A disk of a cluster, and how it moves in one step: r = r_0 + v_0 s + q s^2 + p s^3, the cubic
/// with the positions and velocities of both ends of the step, and a parabola for the spin.
template <bool Rotates>
struct Member {
  std::uint32_t disk;
  Species species;
  DiskMotion<Rotates> begin, end;
  Vec2<Real> bend, twist;  ///< q, p
  Real turn;               ///< thetadot' at the begin, [1 / tau_e^2]

  void join(Real step) {
    Real const i = 1 / step;
    auto const mean = i * (end.position - begin.position);
    auto const &u = begin.motion.velocity, &v = end.motion.velocity;
    bend = i * (3.0 * mean - 2.0 * u - v);
    twist = (i * i) * (u + v - 2.0 * mean);
  }

  Vec2<Real> position(Real s) const {
    return begin.position + s * (begin.motion.velocity + s * (bend + s * twist));
  }
  Vec2<Real> velocity(Real s) const {
    return begin.motion.velocity + s * (2.0 * bend + (3 * s) * twist);
  }
  DiskMotion<Rotates> at(Real s, Real step) const {
    if (s >= step) return end;
    DiskMotion<Rotates> of{position(s), {}};
    of.motion.velocity = velocity(s);
    if constexpr (Rotates) {
      Real const rest = end.motion.spin - begin.motion.spin - turn * step, part = s / step;
      of.motion.spin = begin.motion.spin + turn * s + part * part * rest;
    }
    return of;
  }

  /// Bounds over the step: |r''|, [d_s / tau_e^2].
  Real acceleration(Real step) const {
    auto const last = 2.0 * bend + (6 * step) * twist;
    return std::max(2 * std::sqrt(dot(bend, bend)), std::sqrt(dot(last, last)));
  }
  /// Distance from the line of the begin, [d_s].
  Real deviation(Real step) const {
    return step * step * (std::sqrt(dot(bend, bend)) + step * std::sqrt(dot(twist, twist)));
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
  std::vector<Member<Rotates>> members;  ///< by disk
  std::vector<Link> links;

  Real end() const { return time + step; }
  std::uint32_t slot() const { return members.front().disk; }  ///< in the queue

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
