// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/physics/closed_form/contact_class.hpp"

namespace bagnold {

/// A contact of two disks that touch nobody else, from one instant of it (s = 0) to its end, in
/// closed form. Harmonic repulsion, a linear law, underdamped classes only.
///
/// In polar form, with delta = d_ij - r, n = r_ij/r, t = z^ x n, v_t = r theta', the angular
/// momentum l = r v_t/d_ij, S = (d_i thetadot_i + d_j thetadot_j)/(2 d_ij) and the sliding velocity
/// V = v_t - r S (v_t of a law without spins), the law's equations are
///
///     delta'' = -omega_0^2 delta - 2 b delta' - v_t^2/r
///     l'      = -(k_t/mu) (r/d_ij) V
///     theta'  = d_ij l/r^2
///     thetadot_i' = -mu d_i/(2 I_i) l',  so  K = l + d_ij S/2 is constant
///
/// Where the small e = v_t T/d_ij goes to 0 they are linear: l = l_c + l_e exp(-a s), with l_c =
/// l_0 where k_t = 0, 0 for a law without spins, 2K/3 for one with; delta is a damped oscillator.
/// This keeps, beyond that, all terms of relative order e: the centrifugal v_t^2/r as l^2/d_ij, the
/// turn of the normal by theta, overlaps where they change l of disks that roll and theta. What is
/// left out of velocities is of relative order e^2. Angular momentum, and r = d_ij at the end, are
/// kept to rounding.
///
/// The rate of shear is constant during a contact and a relative velocity holds that of the image,
/// so there is no other force on the relative motion.
///
///     auto const classes = ContactClasses<Law::rotates>::make(law, table);
///     auto const& c = classes(species_i, species_j);
///     auto const centre = c.centre(i, image_of_j);
///     auto const contact = ClosedContact<Law::rotates>::begin(c, pair_motion(i, image_of_j));
///     contact.duration;                 // T, [tau_e]; the end is contact.end, a PairMotion
///     c.disk_i({centre.position + contact.duration * centre.velocity, centre.velocity},
///              contact.end);            // disk i at the end
///     contact.at(c, s);                 // PairMotion at any phase 0 <= s <= T
///     ClosedContact<..>::resume(c, pair_motion(..));  // from mid-contact on
///     // contact_integrals.hpp: time integrals of all columns of sums between two phases
template <bool Rotates>
struct ClosedContact {
  /// All of one phase, in polar form.
  struct Polar {
    Real overlap, approach;  ///< delta, delta'
    Real angular;            ///< l, [d_s / tau_e]
    Vec2<Real> normal;       ///< n
  };

  Vec2<Real> normal;          ///< n at s = 0
  Real overlap;               ///< delta at s = 0, [d_s]
  Real approach;              ///< delta' at s = 0, [d_s / tau_e]
  Real constant, sliding;     ///< l_c, l_e, [d_s / tau_e]
  Real cosine, sine;          ///< P, R: delta = exp(-b s)(P cos + R sin) - sum C_q exp(-q a s)
  Real centrifugal[3];        ///< C_q, [d_s]
  Real duration;              ///< to the end, [tau_e]
  PairMotion<Rotates> start;  ///< at s = 0
  PairMotion<Rotates> end;    ///< at s = duration, where |separation| = d_ij
  Polar last;                 ///< likewise

  /// Disks that come to touch, r_ij = d_ij but for rounding.
  static ClosedContact begin(ContactClass<Rotates> const& c, PairMotion<Rotates> const& pair) {
    ClosedContact k = with(c, pair, true);
    k.find_end(c);
    return k;
  }

  /// Disks in contact for some time already, r_ij <= d_ij: duration is what is left.
  static ClosedContact resume(ContactClass<Rotates> const& c, PairMotion<Rotates> const& pair) {
    ClosedContact k = with(c, pair, false);
    k.find_end(c);
    return k;
  }

  /// Overlap and its derivative.
  struct Radial {
    Real overlap, approach;
  };

  /// Numbers of a phase, which all others are made of.
  struct Phase {
    Real s, decay, cosine, sine;  ///< exp(-b s), cos(omega s), sin(omega s)
    Real slide = 1;               ///< exp(-a s)
    Real slide_time = 0;          ///< (1 - exp(-a s))/a, [tau_e]
  };

  static Phase phase(ContactClass<Rotates> const& c, Real s) {
    Phase p{s, std::exp(-c.damping_rate * s), std::cos(c.frequency * s), std::sin(c.frequency * s)};
    p.slide_time = s;
    if (c.sliding_rate != 0) {
      Real const lost = -std::expm1(-c.sliding_rate * s);
      p.slide = 1 - lost;
      p.slide_time = lost / c.sliding_rate;
    }
    return p;
  }

  Radial radial(ContactClass<Rotates> const& c, Phase const& p) const {
    Real const b = c.damping_rate, w = c.frequency, a = c.sliding_rate;
    Real const first = centrifugal[1] * p.slide, second = centrifugal[2] * p.slide * p.slide;
    return {p.decay * (cosine * p.cosine + sine * p.sine) - (centrifugal[0] + first + second),
            p.decay * ((w * sine - b * cosine) * p.cosine - (w * cosine + b * sine) * p.sine) +
                a * (first + 2 * second)};
  }

  Polar polar(ContactClass<Rotates> const& c, Real s) const {
    Phase const p = phase(c, s);
    return polar(c, p, radial(c, p));
  }

  /// State at a phase 0 <= s <= duration.
  PairMotion<Rotates> at(ContactClass<Rotates> const& c, Real s) const {
    return motion(c, polar(c, s));
  }

  PairMotion<Rotates> motion(ContactClass<Rotates> const& c, Polar const& of) const {
    Real const r = c.distance - of.overlap;
    PairMotion<Rotates> pair;
    pair.separation = r * of.normal;
    pair.velocity =
        (of.angular * c.distance / r) * perpendicular(of.normal) - of.approach * of.normal;
    if constexpr (Rotates) {
      Real const slid = of.angular - (constant + sliding);
      pair.spin_i = start.spin_i - c.spin_gain_i * slid;
      pair.spin_j = start.spin_j - c.spin_gain_j * slid;
    }
    return pair;
  }

  /// Energy of the relative motion, less what no contact can take, [m d_s^2 / tau_e^2].
  Real energy(ContactClass<Rotates> const& c, Polar const& of) const {
    Real const x = of.overlap * c.inverse_distance, l = of.angular, slid = l - constant;
    Real const closer = x * (2 - x) / ((1 - x) * (1 - x));  // (d/r)^2 - 1
    Real const tangential = c.sliding_rate == 0 ? 0 : tangential_mobility(Rotates) * slid * slid;
    return (c.reduced_mass * (of.approach * of.approach + tangential + l * l * closer) + x * x) / 2;
  }

  /// The largest distance, and speed, by which the relative motion may differ from that on the line
  /// of after the contact, and the largest relative acceleration: bounds over 0 <= s <= duration.
  Real largest_deviation() const {
    Real const u = std::sqrt(dot(end.velocity, end.velocity)), l = largest_tangential();
    return 1.05 * (amplitude() + (u + 2 * l) * duration);
  }
  Real largest_speed(ContactClass<Rotates> const& c) const {
    return 1.05 * (amplitude() * std::sqrt(c.frequency02) + largest_tangential());
  }
  Real largest_acceleration(ContactClass<Rotates> const& c) const {
    Real const w0 = std::sqrt(c.frequency02);
    return 1.05 * (amplitude() * (c.frequency02 + 2 * c.damping_rate * w0) +
                   c.sliding_rate * std::fabs(sliding));
  }

  /// Largest overlap at any phase, from above, [d_s].
  Real amplitude() const { return std::fabs(cosine) + std::fabs(sine); }

 private:
  Real largest_tangential() const { return std::fabs(constant) + std::fabs(sliding); }

  static ClosedContact with(ContactClass<Rotates> const& c, PairMotion<Rotates> const& pair,
                            bool fresh) {
    ClosedContact k{};
    k.start = pair;
    Real const r = std::sqrt(dot(pair.separation, pair.separation));
    k.normal = (1 / r) * pair.separation;
    k.overlap = fresh ? 0 : std::max<Real>(c.distance - r, 0);
    k.approach = -dot(pair.velocity, k.normal);
    Real const l = cross(k.normal, pair.velocity) * (r * c.inverse_distance);
    k.constant = l;
    k.sliding = 0;
    if (c.sliding_rate != 0) {
      k.constant = 0;
      if constexpr (Rotates) {
        Real const half_roll = c.distance / 2 * (c.arm_i * pair.spin_i + c.arm_j * pair.spin_j);
        k.constant = 2 * (l + half_roll) / 3;
      }
      k.sliding = l - k.constant;
    }
    Real const b = c.damping_rate, w = c.frequency, a = c.sliding_rate;
    Real const of[3] = {k.constant * k.constant, 2 * k.constant * k.sliding, k.sliding * k.sliding};
    Real sum = 0, slope = 0;
    for (int q = 0; q < 3; ++q) {
      Real const rate = q * a - b;
      k.centrifugal[q] = of[q] * c.inverse_distance / (rate * rate + w * w);
      sum += k.centrifugal[q];
      slope += q * a * k.centrifugal[q];
    }
    k.cosine = k.overlap + sum;
    k.sine = (k.approach + b * k.cosine - slope) / w;
    return k;
  }

  Polar polar(ContactClass<Rotates> const& c, Phase const& p, Radial const& q) const {
    Real const l0 = constant + sliding, a = c.sliding_rate, b = c.damping_rate, w = c.frequency;
    Real const id = c.inverse_distance;
    // integral of the overlap, from that of its equation
    Real const two_slides = p.slide_time * (1 + p.slide) / 2;
    Real const pushed = centrifugal[0] * (b * b + w * w) * p.s +
                        centrifugal[1] * ((a - b) * (a - b) + w * w) * p.slide_time +
                        centrifugal[2] * ((2 * a - b) * (2 * a - b) + w * w) * two_slides;
    Real const sum =
        (approach - q.approach + 2 * b * (overlap - q.overlap) - pushed) / c.frequency02;
    Real l = l0, path = l0 * p.s, path_of_overlap = l0 * sum;
    if (a != 0) {
      Real const rate = -(a + b), three_slides = (p.slide_time + 2 * p.slide * two_slides) / 3;
      Real const fading =  // integral of exp(-a s) delta
          (p.decay * p.slide *
               ((rate * cosine - w * sine) * p.cosine + (w * cosine + rate * sine) * p.sine) -
           (rate * cosine - w * sine)) /
              (rate * rate + w * w) -
          centrifugal[0] * p.slide_time - centrifugal[1] * two_slides -
          centrifugal[2] * three_slides;
      l = constant + sliding * p.slide;
      path = constant * p.s + sliding * p.slide_time;
      path_of_overlap = constant * sum + sliding * fading;
      if constexpr (Rotates) {
        Real const up = a - b;
        Real const growing =  // exp(-a s) times the integral of exp(a s) delta
            (p.decay * ((up * cosine - w * sine) * p.cosine + (w * cosine + up * sine) * p.sine) -
             p.slide * (up * cosine - w * sine)) /
                (up * up + w * w) -
            centrifugal[0] * p.slide_time - centrifugal[1] * p.s * p.slide -
            centrifugal[2] * p.slide * p.slide_time;
        Real const more = sliding * p.slide * sum - constant / 2 * growing;
        l += 4 * a / 3 * id * more;
        path += 4 * id / 3 * (sliding * fading - constant / 2 * sum - more);
      }
    }
    Real const theta = id * (path + 2 * id * path_of_overlap);
    Real const cosine_of = std::cos(theta), sine_of = std::sin(theta);
    return {q.overlap,
            q.approach,
            l,
            {cosine_of * normal.x - sine_of * normal.y, sine_of * normal.x + cosine_of * normal.y}};
  }

  void find_end(ContactClass<Rotates> const& c) {
    Real const nothing = 0;
    if (overlap <= 0 && approach <= 0) {  // they part, or graze: no time in contact
      duration = nothing;
      last = {0, approach, constant + sliding, normal};
      end = start;
      return;
    }
    Real low = 0, high = (std::numbers::pi - std::atan2(cosine, sine)) / c.frequency;
    while (radial(c, phase(c, high)).overlap > 0) high += 0.1 / c.frequency;
    Real s = high;
    if (overlap == 0) {  // a grazing contact is a chord
      Real const l = constant + sliding;
      s = std::min(high, 2 * approach * c.distance / (l * l + 1e-300));
    }
    Radial q{};
    for (int n = 0; n < 60; ++n) {
      q = radial(c, phase(c, s));
      (q.overlap > 0 ? low : high) = s;
      Real next = q.approach < 0 ? s - q.overlap / q.approach : (low + high) / 2;
      if (!(next >= low && next <= high)) next = (low + high) / 2;
      bool const found = std::fabs(next - s) <= 1e-15 * c.half_period;
      s = next;
      if (found) break;
    }
    duration = s;
    Phase const p = phase(c, s);
    q = radial(c, p);
    q.overlap = 0;
    q.approach = std::min(q.approach, nothing);
    last = polar(c, p, q);
    end = motion(c, last);
  }
};

}  // namespace bagnold
