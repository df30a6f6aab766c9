// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/physics/closed_form/closed_contact.hpp"
#include "kernels/physics/closed_form/node_numbers.hpp"
#include "kernels/physics/sums/contact_motion.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Integrals over a contact, or part of one, of the columns of SumColumns and ContactMotion. With
/// them a mean over a window needs no samples.
///
/// With G = k_n (d_ij delta - delta^2/2), the virial f_a r_b of both forces is
///
///     elastic:      integral of (delta/d_ij^2) r n n
///     dissipative:  [G n n] - integral of G theta' (n t + t n) - integral of k_t r V t n,
///
/// the first of which is k_n r delta' n n integrated by parts. So its trace is [G], 0 over whole
/// contacts to rounding; it is not symmetric where k_t is not 0. The dissipated energy, and the
/// energy that goes into rotation, are differences of the energies at both phases. All other
/// columns use Gauss's rule on the closed form, in pieces short enough for an error of 1e-10 of the
/// contact's own scale.
///
/// A negative weight subtracts a part: if a contact is cut at phase s, the sums up to its duration
/// are corrected by -1 times the integrals from s to duration.
///
///     ContactIntegrals<Law::rotates> const integrals{c};
///     integrals.over(contact, 0, contact.duration, [&](auto const& nodes) {
///       nodes.add_pair_columns(columns, 1);
///       nodes.add_motion_columns(columns, centre, m_i, m_j, strain_rate, 1);
///       nodes.add_contact_motion(motion, 1);
///     });
template <bool Rotates>
struct ContactIntegrals {
  using Closed = ClosedContact<Rotates>;

  ContactClass<Rotates> const& c;

  /// A contact at the nodes between two phases.
  struct Nodes {
    ContactIntegrals const& of;
    Closed const& contact;
    Real half;                        ///< of the time between the two, [tau_e]
    PolarMotion<Real> before, after;  ///< at the two phases
    AtNodes time, closer, stretched;  ///< s, r/d_ij, d_ij/r
    AtNodes tangential, roll;         ///< v_t, and (d_i thetadot_i + d_j thetadot_j)/(2 d_ij)
    PolarMotion<AtNodes> polar;
    Vec2<AtNodes> separation, velocity;

    /// Adds to the columns of pairs and `contacts`, and to torque_power of a law that rotates. to:
    /// indexed by column.
    template <class Columns>
    void add_pair_columns(Columns& to, Real weight = 1) const {
      using C = SumColumns;
      auto const& c = of.c;
      Real const w = weight * half, k_n = c.normal_damping, k_t = c.tangential_damping;
      auto const& n = polar.normal;
      AtNodes const xx = n.x * n.x, xy = n.x * n.y, yy = n.y * n.y;
      AtNodes const elastic = AtNodes(c.inverse_distance) * polar.overlap * closer;
      to[C::elastic_xx] += w * (elastic * xx).integral();
      to[C::elastic_xy] += w * (elastic * xy).integral();
      to[C::elastic_yy] += w * (elastic * yy).integral();
      // theta' = d_ij l/r^2 = v_t/r
      AtNodes const turned = AtNodes(k_n / 2) * polar.overlap * (AtNodes(1) + closer) *
                             (tangential * stretched);  // G theta'
      Real const twice = 2 * w * (turned * xy).integral();
      Real const across = -w * (turned * (xx - yy)).integral();
      Vec2<Real> const &a = before.normal, &b = after.normal;
      Real const g = weight * of.potential(before), h = weight * of.potential(after);
      to[C::dissipative_xx] += h * b.x * b.x - g * a.x * a.x + twice;
      to[C::dissipative_xy] += h * b.x * b.y - g * a.x * a.y + across;
      to[C::dissipative_yx] += h * b.x * b.y - g * a.x * a.y + across;
      to[C::dissipative_yy] += h * b.y * b.y - g * a.y * a.y - twice;
      if (k_t != 0) {
        AtNodes const r = AtNodes(c.distance) * closer;
        AtNodes sliding = tangential;
        if constexpr (Rotates) sliding = sliding - r * roll;
        AtNodes const pull = AtNodes(-k_t) * r * sliding;
        Real const turn = w * (pull * xy).integral();
        to[C::dissipative_xx] -= turn;
        to[C::dissipative_xy] -= w * (pull * yy).integral();
        to[C::dissipative_yx] += w * (pull * xx).integral();
        to[C::dissipative_yy] += turn;
      }
      to[C::dissipation] += weight * (contact.energy(c, before) - contact.energy(c, after));
      to[C::contacts] += 4 * w;
      if constexpr (Rotates)
        to[C::torque_power] +=
            weight * (of.rotational_energy(contact, after) - of.rotational_energy(contact, before));
    }

    /// Adds the columns of the motion of both disks: kinetic_xx .. velocity_y2, spin, spin2.
    /// centre: at phase 0, in a frame where y = 0 is that of the box. mass: m_i, m_j.
    template <class Columns>
    void add_motion_columns(Columns& to, PairCentre const& centre, Real mass_i, Real mass_j,
                            Real strain_rate, Real weight = 1) const {
      auto const& c = of.c;
      Integrated<Columns> integrated{to, weight * half};
      AtNodes const y = AtNodes(centre.position.y) + AtNodes(centre.velocity.y) * time;
      AtNodes const ux = peculiar_x(AtNodes(centre.velocity.x), y, strain_rate);
      AtNodes const vx = peculiar_x(velocity.x, separation.y, strain_rate);
      auto const add = [&](Real mass, Real share) {
        add_motion(integrated, AtNodes(mass), ux + AtNodes(share) * vx,
                   AtNodes(centre.velocity.y) + AtNodes(share) * velocity.y);
      };
      add(mass_i, c.share_i);
      add(mass_j, -c.share_j);
      if constexpr (Rotates) {
        add_spin(integrated, contact.spin_i(c, polar));
        add_spin(integrated, contact.spin_j(c, polar));
      }
    }

    void add_contact_motion(ContactMotion& to, Real weight = 1) const {
      using M = ContactMotion;
      Real const w = weight * half;
      AtNodes const& vn = polar.approach;
      auto const add = [&](int column, AtNodes const& value) {
        to.value[column] += w * value.integral();
      };
      add(M::normal2, vn * vn);
      add(M::tangential2, tangential * tangential);
      add(M::tangential_normal, -(tangential * vn));
      add(M::tangential, -tangential);
      to.value[M::normal] += weight * (after.overlap - before.overlap);
      to.value[M::contacts] += 2 * w;
      if constexpr (Rotates) {
        AtNodes const rolled = AtNodes(of.c.distance) * closer * roll;
        add(M::rotational2, rolled * rolled);
        add(M::tangential_rotational, -(tangential * rolled));
        add(M::rotational_normal, vn * rolled);
        add(M::rotational, rolled);
      }
    }
  };

  /// Calls with(Nodes) for each of the pieces between two phases.
  template <class With>
  void over(Closed const& contact, Real from, Real until, With const& with) const {
    // 8 nodes integrate exp(-x) over a piece of x = 8, cos(x) over 7, to 1e-9
    Real const rate = std::fmax(c.frequency0 / 3.5, c.rates.sliding / 4);
    int const pieces = std::max(1, static_cast<int>(std::ceil((until - from) * rate)));
    auto before = from == 0 ? contact.first() : contact.polar(c, from);
    for (int k = 1; k <= pieces; ++k) {
      Real const end = k == pieces ? until : from + (until - from) * k / pieces;
      auto const after = end == contact.duration ? contact.last : contact.polar(c, end);
      with(nodes(contact, from + (until - from) * (k - 1) / pieces, end, before, after));
      before = after;
    }
  }

 private:
  /// Columns to which integrals are added.
  template <class Columns>
  struct Integrated {
    struct Column {
      Real& sum;
      Real weight;
      void operator+=(AtNodes const& value) const { sum += weight * value.integral(); }
    };
    Columns& to;
    Real weight;
    Column operator[](int column) const { return {to[column], weight}; }
  };

  Nodes nodes(Closed const& contact, Real from, Real until, PolarMotion<Real> const& before,
              PolarMotion<Real> const& after) const {
    Real const half = (until - from) / 2, middle = from + half;
    auto const phases = [&] {
      if (from == 0) {
        Real const early = c.half_period - until, by = std::fabs(early) * c.rates.largest();
        if (by < ContactRates::slight)
          return c.rates.slightly_earlier(c.nodes,
                                          AtNodes(early / 2) * (AtNodes(1) + AtNodes::abscissas()),
                                          by < ContactRates::slight / 16);
      }
      return c.rates.earlier(c.rates.phase(middle), AtNodes(-half) * AtNodes::abscissas());
    }();
    auto const polar = contact.polar(c, phases);
    AtNodes const closer = AtNodes(1) - polar.overlap * AtNodes(c.inverse_distance);
    AtNodes const stretched = AtNodes(1) / closer, r = AtNodes(c.distance) * closer;
    AtNodes const tangential = polar.angular * stretched;
    Nodes n{*this,
            contact,
            half,
            before,
            after,
            phases.time,
            closer,
            stretched,
            tangential,
            AtNodes(0),
            polar,
            r * polar.normal,
            tangential * perpendicular(polar.normal) - polar.approach * polar.normal};
    if constexpr (Rotates)
      n.roll =
          AtNodes(c.arm_i) * contact.spin_i(c, polar) + AtNodes(c.arm_j) * contact.spin_j(c, polar);
    return n;
  }

  /// G
  Real potential(PolarMotion<Real> const& at) const {
    return c.normal_damping * at.overlap * (c.distance - at.overlap / 2);
  }

  /// Up to a constant, [m d_s^2 / tau_e^2]; I times spin_gain is mu d/2.
  Real rotational_energy(Closed const& contact, PolarMotion<Real> const& at) const {
    Real const slid = at.angular - (contact.constant + contact.sliding);
    Real const mean = c.arm_i * contact.spins.i + c.arm_j * contact.spins.j;
    return c.reduced_mass * slid * (slid - c.distance * mean);
  }
};

}  // namespace bagnold
