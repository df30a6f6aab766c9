// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/events/speeds.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold::events {

/// Adds integrals of u_x^2, u_x u_y and u_y^2, u = v - gammadot y x^, to the columns of motion.
inline void add_motion(Real* to, Real mass, Real xx, Real xy, Real yy) {
  using C = SumColumns;
  to[C::kinetic_xx] += mass * xx;
  to[C::kinetic_xy] += mass * xy;
  to[C::kinetic_yy] += mass * yy;
  to[C::velocity_x2] += xx;
  to[C::velocity_y2] += yy;
}

/// Adds the integrals of the columns of motion over a straight flight of a time, times a weight.
/// position: where it begins, [d_s]. u = v - gammadot y x^ is linear in time, so
///
///     integral of u_x^2 = t (a^2 + a b + b^2)/3,   a, b: u_x at both ends
template <bool Rotates>
void add_flight(Real* to, Real mass, Vec2<Real> const& position, Motion<Rotates> const& motion,
                Real strain_rate, Real time, Real weight) {
  using C = SumColumns;
  Real const vy = motion.velocity.y;
  Real const a = peculiar_x(motion.velocity.x, position.y, strain_rate);
  Real const b = peculiar_x(motion.velocity.x, position.y + vy * time, strain_rate);
  Real const w = weight * time;
  Real const xx = w * (a * a + a * b + b * b) / 3, xy = w * (a + b) / 2 * vy, yy = w * vy * vy;
  add_motion(to, mass, xx, xy, yy);
  if constexpr (Rotates) {
    to[C::spin] += w * motion.spin;
    to[C::spin2] += w * motion.spin * motion.spin;
  }
}

/// Adds a flight over which the speed of time changes. mass: at speed 1.
template <bool Rotates>
void add_flight(Real* to, Real mass, Vec2<Real> const& position, Motion<Rotates> const& motion,
                Real strain_rate, Speeds::Integrals const& over, Real weight) {
  using C = SumColumns;
  Real const vy = motion.velocity.y;
  Real const u = peculiar_x(motion.velocity.x, position.y, strain_rate), slope = -strain_rate * vy;
  Real const xx = weight * (u * u * over.one + slope * (2 * u * over.time + slope * over.time2));
  Real const xy = weight * (u * over.one + slope * over.time) * vy;
  Real const yy = weight * over.one * vy * vy;
  add_motion(to, mass, xx, xy, yy);
  if constexpr (Rotates) {
    to[C::spin] += weight * over.length * motion.spin;
    to[C::spin2] += weight * over.one * motion.spin * motion.spin;
  }
}

}  // namespace bagnold::events
