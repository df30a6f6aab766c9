// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Beginning or end of a contact: r_ij < d_ij in one of two configurations a step apart and not in
/// the other.
struct ContactEvent {
  std::int64_t step =
      0;  ///< of the later configuration: the first in contact, or the first out of it
  bool begins = false;
  std::uint32_t a = 0, b = 0;  ///< disks by their index at the start, a < b
  Real theta = 0;              ///< from the relative velocity to the separation there, [degrees]

  /// Order of events. In one configuration ends come before beginnings: a contact that begins there
  /// does not overlap in time with one that ends there.
  friend bool operator<(ContactEvent const& l, ContactEvent const& r) {
    return std::tie(l.step, l.begins, l.a, l.b) < std::tie(r.step, r.begins, r.a, r.b);
  }
};

/// theta of P2 Eq. (27), counter-clockwise from v_ij to r_ij, in -180 .. 180 degrees. The same for
/// v_ji and r_ji.
inline Real collision_angle(Vec2<Real> const& velocity, Vec2<Real> const& separation) {
  constexpr Real degrees = 180 / 3.14159265358979323846;
  return degrees * std::atan2(cross(velocity, separation), dot(velocity, separation));
}

inline ContactEvent contact_event(std::int64_t step, bool begins, std::uint32_t a, std::uint32_t b,
                                  Vec2<Real> const& separation, Vec2<Real> const& velocity) {
  if (b < a) std::swap(a, b);
  return {step, begins, a, b, collision_angle(velocity, separation)};
}

}  // namespace bagnold
