// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "kernels/physics/closed_form/contact_phase.hpp"
#include "kernels/physics/closed_form/node_numbers.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// A disk, or the image of one, at one instant.
template <bool Rotates>
struct DiskMotion {
  Vec2<Real> position;     ///< [d_s]
  Motion<Rotates> motion;  ///< lab frame, an image with the shear of the box
};

/// Motion of disk i relative to disk j, or to an image of it.
template <bool Rotates>
struct PairMotion {
  Vec2<Real> separation;  ///< r_ij = r_i - r_j, [d_s]
  Vec2<Real> velocity;    ///< v_i - v_j, [d_s / tau_e]
};

template <>
struct PairMotion<true> {
  Vec2<Real> separation, velocity;
  Real spin_i, spin_j;  ///< thetadot, counter-clockwise, [1 / tau_e]
};

/// Centre of mass of two disks. It moves on a straight line while they touch no other disk.
struct PairCentre {
  Vec2<Real> position, velocity;
};

/// Constants of the contacts of a disk i with a disk j: harmonic repulsion, a linear law.
///
/// With mu = m_i m_j/(m_i + m_j), along the normal and along the tangent
///
///     delta'' = -omega_0^2 delta - 2 b delta' - ..,   omega_0^2 = k_e/(mu d_ij^2),  b = k_n/(2 mu)
///     V' = -a V - ..,     a = k_t/mu, where disks roll 3 k_t/mu
///
/// where V is the sliding velocity at the point of contact (closed_contact.hpp has the equations).
template <bool Rotates>
struct ContactClass {
  Real distance;                  ///< d_ij, [d_s]
  Real inverse_distance;          ///< 1/d_ij
  Real reduced_mass;              ///< mu, [m]
  Real share_i, share_j;          ///< mu/m_i, mu/m_j: of the relative motion
  Real arm_i, arm_j;              ///< d_i/(d_i + d_j), d_j/(d_i + d_j): P2 Eq. (6)
  Real spin_gain_i, spin_gain_j;  ///< mu d/(2 I) = 4 mu/(m d), [1 / d_s]; spins per sliding
  Real normal_damping;            ///< k_n, [m / tau_e]
  Real tangential_damping;        ///< k_t
  Real frequency0, frequency02;   ///< omega_0, [1 / tau_e], and its square
  ContactRates rates;             ///< b, omega, a, [1 / tau_e]
  Real inverse_frequency;         ///< 1/omega, [tau_e]
  Real push[3];                   ///< (q a - b)^2 + omega^2, q = 0, 1, 2, [1 / tau_e^2]
  Real centrifugal_gain[3];       ///< of l^2 in exp(-q a s): 1/(d_ij push), [tau_e^2 / d_s]
  Real half_period;               ///< pi/omega, duration of a head-on contact, [tau_e]
  ContactPhase<Real> end;         ///< at half_period
  ContactPhase<AtNodes> nodes;    ///< at the nodes between 0 and half_period

  /// True if contacts are underdamped, so that they end. An overdamped contact has no end in closed
  /// form. Contacts are overdamped for Q below d_ij/(2 sqrt(mu)) for k_n = 1/Q, which is 0.564 to
  /// 0.588 for masses by area, 0.707 to 0.990 for equal ones.
  bool underdamped() const { return rates.frequency > 0; }

  /// k_n, k_t of a law, [m / tau_e].
  static ContactClass of_constants(Real normal, Real tangential, SpeciesTable const& table,
                                   Species i, Species j) {
    ContactClass c{};
    Real const inverse_i = table.inverse_mass[i], inverse_j = table.inverse_mass[j];
    Real const d_i = table.diameter[i], d_j = table.diameter[j];
    c.distance = class_distance(pair_class(i, j));
    c.inverse_distance = 1 / c.distance;
    c.reduced_mass = 1 / (inverse_i + inverse_j);
    c.share_i = c.reduced_mass * inverse_i;
    c.share_j = c.reduced_mass * inverse_j;
    c.arm_i = d_i / (d_i + d_j);
    c.arm_j = d_j / (d_i + d_j);
    c.spin_gain_i = c.reduced_mass * d_i / 2 * table.inverse_inertia[i];
    c.spin_gain_j = c.reduced_mass * d_j / 2 * table.inverse_inertia[j];
    c.normal_damping = normal;
    c.tangential_damping = tangential;
    c.frequency02 = 1 / (c.reduced_mass * c.distance * c.distance);
    c.frequency0 = std::sqrt(c.frequency02);
    Real const b = c.normal_damping / (2 * c.reduced_mass);
    Real const a = tangential_mobility(Rotates) * c.tangential_damping / c.reduced_mass;
    Real const frequency2 = c.frequency02 - b * b;
    c.rates = {b, frequency2 > 0 ? std::sqrt(frequency2) : 0, a};
    if (!c.underdamped()) return c;
    c.inverse_frequency = 1 / c.rates.frequency;
    for (int q = 0; q < 3; ++q) {
      c.push[q] = (q * a - b) * (q * a - b) + frequency2;
      c.centrifugal_gain[q] = c.inverse_distance / c.push[q];
    }
    c.half_period = std::numbers::pi * c.inverse_frequency;
    c.end = c.rates.phase(c.half_period);
    c.end.cosine = -1;
    c.end.sine = 0;
    for (int k = 0; k < AtNodes::count; ++k) {
      auto const p = c.rates.phase(c.half_period / 2 * (1 + AtNodes::abscissas().v[k]));
      c.nodes.time.v[k] = p.time;
      c.nodes.decay.v[k] = p.decay;
      c.nodes.cosine.v[k] = p.cosine;
      c.nodes.sine.v[k] = p.sine;
      c.nodes.slide.v[k] = p.slide;
      c.nodes.slide_time.v[k] = p.slide_time;
    }
    return c;
  }

  /// Centre of mass of two disks; and each disk from the centre and the relative motion.
  PairCentre centre(DiskMotion<Rotates> const& i, DiskMotion<Rotates> const& j) const {
    return {share_j * i.position + share_i * j.position,
            share_j * i.motion.velocity + share_i * j.motion.velocity};
  }

  DiskMotion<Rotates> disk_i(PairCentre const& centre, PairMotion<Rotates> const& pair) const {
    DiskMotion<Rotates> of{centre.position + share_i * pair.separation, {}};
    of.motion.velocity = centre.velocity + share_i * pair.velocity;
    if constexpr (Rotates) of.motion.spin = pair.spin_i;
    return of;
  }
  DiskMotion<Rotates> disk_j(PairCentre const& centre, PairMotion<Rotates> const& pair) const {
    DiskMotion<Rotates> of{centre.position - share_j * pair.separation, {}};
    of.motion.velocity = centre.velocity - share_j * pair.velocity;
    if constexpr (Rotates) of.motion.spin = pair.spin_j;
    return of;
  }
};

/// Relative motion of two disks.
template <bool Rotates>
PairMotion<Rotates> pair_motion(DiskMotion<Rotates> const& i, DiskMotion<Rotates> const& j) {
  PairMotion<Rotates> pair;
  pair.separation = i.position - j.position;
  pair.velocity = i.motion.velocity - j.motion.velocity;
  if constexpr (Rotates) {
    pair.spin_i = i.motion.spin;
    pair.spin_j = j.motion.spin;
  }
  return pair;
}

/// The contact classes of a law, by the species of i and of j.
template <bool Rotates>
struct ContactClasses {
  ContactClass<Rotates> of[2][2];

  ContactClass<Rotates> const& operator()(Species i, Species j) const { return of[i][j]; }
};

}  // namespace bagnold
