// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/closed_form/closed_contact.hpp"
#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/sums/contact_motion.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Gauss's rule on (-1, 1): abscissas > 0 and their weights.
struct GaussNodes {
  static constexpr int count = 8;
  static constexpr Real abscissa[count / 2] = {0.1834346424956498049, 0.5255324099163289858,
                                               0.7966664774136267396, 0.9602898564975362317};
  static constexpr Real weight[count / 2] = {0.3626837833783619830, 0.3137066458778872873,
                                             0.2223810344533744706, 0.1012285362903762591};

  /// Calls at(time, weight) for the nodes between two times.
  template <class At>
  static void between(Real from, Real to, At const& at) {
    Real const half = (to - from) / 2, middle = from + half;
    for (int k = 0; k < count / 2; ++k)
      for (int const side : {-1, 1}) at(middle + side * half * abscissa[k], half * weight[k]);
  }
};

/// Integrals over a contact, or part of one, of what SumColumns and ContactMotion sum over a
/// configuration: so a mean over a window needs no samples.
///
/// The trace of the dissipative virial is [d_ij delta - delta^2/2] k_n between the two phases, 0
/// over whole contacts to rounding; the dissipated energy is what the motion has lost. All else is
/// Gauss's rule on the closed form, whose error is below 1e-8 of a whole contact at any restitution
/// above 0.1.
///
/// A negative weight takes a part back: where a contact is cut at phase s, what was added up to
/// its duration is corrected by -1 times the integrals from s to duration.
template <LinearLaw Law>
struct ContactIntegrals {
  static constexpr bool rotates = Law::rotates;
  using Closed = ClosedContact<rotates>;

  Law const& law;
  ContactClass<rotates> const& c;

  /// Adds to the columns of pairs and `contacts`, and to torque_power of a law that rotates. to:
  /// indexed by column.
  template <class Columns>
  void add_pair_columns(Columns& to, Closed const& contact, Real from, Real until,
                        Real weight = 1) const {
    Real sum[pair_columns] = {}, torque_power = 0;
    GaussNodes::between(from, until, [&](Real s, Real w) {
      auto const polar = contact.polar(c, s);
      auto const pair = contact.motion(c, polar);
      auto const force = pair_force(polar, pair);
      auto const of = columns_of(force);
      for (int k = 0; k < pair_columns; ++k) sum[k] += w * of.value[k];
      if constexpr (rotates) {
        Real const torque = force.torque_per_diameter(c.inverse_distance);
        torque_power += w * torque * 2 * c.distance * roll(pair);
      }
    });
    auto const first = contact.polar(c, from);
    auto const last = until == contact.duration ? contact.last : contact.polar(c, until);
    using C = SumColumns;
    Real const excess = trace(first, last) - (sum[C::dissipative_xx] + sum[C::dissipative_yy]);
    sum[C::dissipative_xx] += excess / 2;
    sum[C::dissipative_yy] += excess / 2;
    sum[C::dissipation] = contact.energy(c, first) - contact.energy(c, last);
    for (int k = 0; k < pair_columns; ++k) to[k] += weight * sum[k];
    to[C::contacts] += 2 * weight * (until - from);
    if constexpr (rotates) to[C::torque_power] += weight * torque_power;
  }

  /// Adds the columns of the motion of both disks: kinetic_xx .. velocity_y2, spin, spin2. centre:
  /// at phase 0, in a frame where y = 0 is that of the box.
  template <class Columns>
  void add_motion_columns(Columns& to, Closed const& contact, PairCentre const& centre, Real mass_i,
                          Real mass_j, Real strain_rate, Real from, Real until,
                          Real weight = 1) const {
    GaussNodes::between(from, until, [&](Real s, Real w) {
      auto const pair = contact.at(c, s);
      PairCentre const now{centre.position + s * centre.velocity, centre.velocity};
      auto const add = [&](DiskMotion<rotates> const& disk, Real mass) {
        Weighed<Columns> weighed{to, weight * w};
        add_motion(weighed, mass, peculiar_x(disk.motion.velocity.x, disk.position.y, strain_rate),
                   disk.motion.velocity.y);
        if constexpr (rotates) add_spin(weighed, disk.motion.spin);
      };
      add(c.disk_i(now, pair), mass_i);
      add(c.disk_j(now, pair), mass_j);
    });
  }

  /// Adds what the contact moves, see ContactMotion.
  void add_contact_motion(ContactMotion& to, Closed const& contact, Real from, Real until,
                          Real weight = 1) const {
    GaussNodes::between(from, until, [&](Real s, Real w) {
      auto const pair = contact.at(c, s);
      to.add(weight * w, pair.separation, pair.velocity, roll(pair));
    });
  }

 private:
  template <class Columns>
  struct Weighed {
    struct Column {
      Real& sum;
      Real weight;
      void operator+=(Real value) const { sum += weight * value; }
    };
    Columns& to;
    Real weight;
    Column operator[](int column) const { return {to[column], weight}; }
  };

  /// (d_i thetadot_i + d_j thetadot_j)/(d_i + d_j), [1 / tau_e]; 0 without spins.
  Real roll(PairMotion<rotates> const& pair) const {
    if constexpr (rotates)
      return c.arm_i * pair.spin_i + c.arm_j * pair.spin_j;
    else
      return 0;
  }

  Real trace(typename Closed::Polar const& a, typename Closed::Polar const& b) const {
    return c.normal_damping * (b.overlap - a.overlap) * (c.distance - (a.overlap + b.overlap) / 2);
  }

  PairForce<Real> pair_force(typename Closed::Polar const& polar,
                             PairMotion<rotates> const& pair) const {
    Contact<Real> contact;
    contact.normal = polar.normal;
    contact.relative_overlap = polar.overlap * c.inverse_distance;
    contact.inverse_distance = c.inverse_distance;
    contact.velocity = velocity_at_contact<Law>(pair.velocity, pair.separation, c.inverse_distance,
                                                2 * c.distance * roll(pair));
    return {pair.separation, HarmonicRepulsion{}.magnitude(contact) * contact.normal,
            law.dissipative_force(contact), contact.relative_overlap, contact.velocity};
  }
};

}  // namespace bagnold
