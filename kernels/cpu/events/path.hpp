// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/cpu/events/tournament.hpp"
#include "kernels/physics/species.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold::events {

/// How a disk moves before its line begins.
enum class Manner : std::uint8_t {
  free,     ///< on its line
  contact,  ///< with one other disk, in closed form, and on its line afterwards
  cluster   ///< in a cluster, by steps: the line is one that it stays near for a time
};

/// The path of a disk from its last change on, in times since the lists were built. It ends on a
/// straight line, on which the disk flies until something hits it. Of a disk in a cluster it is a
/// corridor: the disk keeps within `deviation` of the line until `straight`. One cache line.
struct alignas(64) Path {
  Vec2<Real> place;     ///< of the line at time 0, [d_s]
  Vec2<Real> velocity;  ///< on the line, [d_s / tau_e]
  Real begun = 0;       ///< from when on this is the path, [tau_e]
  Real straight = 0;    ///< from when on it is the line; of a corridor: its end
  Real deviation = 0;   ///< largest distance from the line in between, [d_s]
  std::uint32_t changes = 0;
  Species species = 0;
  Manner manner = Manner::free;
  std::uint16_t one = 0x3ff0;  ///< makes the last eight bytes a number near 1, for packs

  Vec2<Real> at(Real time) const { return place + time * velocity; }

  /// The line through a position at a time.
  void fly(Vec2<Real> const& position, Vec2<Real> const& v, Real time) {
    velocity = v;
    place = position - time * v;
  }
};
static_assert(sizeof(Path) == 64);

/// Disk i against the image of j, both on their lines.
struct LinePair {
  Vec2<Real> separation, velocity;  ///< r_ij at time `from`, [d_s]; v_ij, [d_s / tau_e]
  Real from;                        ///< when both have come to their lines
  Real approach;                    ///< r_ij . v_ij
  Real beyond;                      ///< r_ij^2 - d_ij^2
  Real velocity2;

  /// When they touch, or `never`. Of disks that overlap and approach each other: at once.
  Real touch() const {
    if (approach >= 0) return never;
    Real const discriminant = approach * approach - velocity2 * beyond;
    if (discriminant <= 0) return never;
    Real const wait = beyond / (std::sqrt(discriminant) - approach);
    return from + std::max<Real>(wait, 0);
  }
};

}  // namespace bagnold::events
