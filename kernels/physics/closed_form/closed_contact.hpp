// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/physics/closed_form/contact_class.hpp"

namespace bagnold {

/// Two disks in contact at one phase, in polar form. T: a number, or one for each of many phases.
template <class T>
struct PolarMotion {
  T overlap;       ///< delta = d_ij - r_ij, [d_s]
  T approach;      ///< delta', [d_s / tau_e]
  T angular;       ///< l = r v_t/d_ij, [d_s / tau_e]
  Vec2<T> normal;  ///< n, from j to i
};

/// thetadot of both disks at s = 0, [1 / tau_e].
template <bool Rotates>
struct StartSpins {};

template <>
struct StartSpins<true> {
  Real i, j;
};

/// A contact of two disks that touch no other disk, from one instant of it (s = 0) to its end, in
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
/// They are linear where e = v T/d_ij goes to 0 (v: relative speed): l = l_c + l_e exp(-a s), with
/// l_c = l_0 where k_t = 0, 0 for a law without spins, 2K/3 for one with; delta is a damped
/// oscillator. This keeps, beyond that, all terms of relative order e: the centrifugal v_t^2/r as
/// l^2/d_ij, the turn of the normal by theta, overlaps where they change l of disks that roll and
/// theta. Head-on contacts without sliding, angular momentum, and r = d_ij at the end are exact.
///
/// What is left out is of relative order e^2: below 0.15 e^2 of T, 0.03 e^2 of v for velocities at
/// the end and 0.1 e^2 on the way, 0.3 e^2 of integrals (tests/kernels/physics/closed_form).
/// Normals turn by 16 gammadot tau_e, root mean square, at phi = 0.78, Q = 50, and by 11 at Q = 1,
/// so at a rate of 1e-4 that is 7e-7 and 2e-7 of T: the next order, of which the term 3 l^2
/// delta/d_ij^2 of delta'' is the largest, would not be seen. A frozen normal would leave out e/2.
///
/// The rate of shear is constant during a contact and a relative velocity holds that of the image,
/// so there is no other force on the relative motion.
///
///     auto const c = ContactClass<Law::rotates>::of_constants(k_n, k_t, table, species_i,
///                                                             species_j);
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
  using Class = ContactClass<Rotates>;

  Vec2<Real> normal;        ///< n at s = 0
  Real overlap;             ///< delta at s = 0, [d_s]
  Real approach;            ///< delta' at s = 0, [d_s / tau_e]
  Real constant, sliding;   ///< l_c, l_e, [d_s / tau_e]
  Real cosine, sine;        ///< P, R: delta = exp(-b s)(P cos + R sin) - sum C_q exp(-q a s)
  Real centrifugal[3];      ///< C_q, [d_s]
  Real duration;            ///< to the end, [tau_e]
  PolarMotion<Real> last;   ///< at s = duration, where |separation| = d_ij
  PairMotion<Rotates> end;  ///< at s = duration
  [[no_unique_address]] StartSpins<Rotates> spins;

  /// Contact of disks that come to touch, r_ij = d_ij up to rounding.
  static ClosedContact begin(Class const& c, PairMotion<Rotates> const& pair) {
    ClosedContact k = with(c, pair, true);
    if (k.approach > 0)
      k.find_end(c);
    else
      k.end_at_once(pair);
    return k;
  }

  /// Contact of disks in contact for some time already, r_ij <= d_ij; duration is the remaining
  /// time.
  static ClosedContact resume(Class const& c, PairMotion<Rotates> const& pair) {
    ClosedContact k = with(c, pair, false);
    if (k.overlap > 0 || k.approach > 0)
      k.search_end(c);
    else
      k.end_at_once(pair);
    return k;
  }

  /// State at a phase 0 <= s <= duration.
  PairMotion<Rotates> at(Class const& c, Real s) const { return motion(c, polar(c, s)); }

  PolarMotion<Real> first() const { return {overlap, approach, constant + sliding, normal}; }
  PolarMotion<Real> polar(Class const& c, Real s) const {
    auto const p = c.rates.phase(s);
    return polar(c, p, radial(c, p));
  }
  template <class T>
  PolarMotion<T> polar(Class const& c, ContactPhase<T> const& p) const {
    return polar(c, p, radial(c, p));
  }

  /// Motion of the pair from polar form.
  PairMotion<Rotates> motion(Class const& c, PolarMotion<Real> const& of) const {
    PairMotion<Rotates> pair;
    pair.separation = (c.distance - of.overlap) * of.normal;
    pair.velocity = tangential(c, of) * perpendicular(of.normal) - of.approach * of.normal;
    if constexpr (Rotates) {
      pair.spin_i = spin_i(c, of);
      pair.spin_j = spin_j(c, of);
    }
    return pair;
  }

  /// v_t
  template <class T>
  T tangential(Class const& c, PolarMotion<T> const& of) const {
    return of.angular / (T(1) - of.overlap * T(c.inverse_distance));
  }

  /// thetadot of i and of j.
  template <class T>
  T spin_i(Class const& c, PolarMotion<T> const& of) const {
    return T(spins.i) - T(c.spin_gain_i) * (of.angular - T(constant + sliding));
  }
  template <class T>
  T spin_j(Class const& c, PolarMotion<T> const& of) const {
    return T(spins.j) - T(c.spin_gain_j) * (of.angular - T(constant + sliding));
  }

  /// Energy of the relative motion and the overlap, up to a constant, [m d_s^2 / tau_e^2].
  Real energy(Class const& c, PolarMotion<Real> const& of) const {
    Real const x = of.overlap * c.inverse_distance, l = of.angular, slid = l - constant;
    Real const closer = x * (2 - x) / ((1 - x) * (1 - x));  // (d/r)^2 - 1
    Real const tangential = c.rates.sliding == 0 ? 0 : tangential_mobility(Rotates) * slid * slid;
    return (c.reduced_mass * (of.approach * of.approach + tangential + l * l * closer) + x * x) / 2;
  }

  /// Bounds over 0 <= s <= duration. Largest overlap, [d_s]:
  Real largest_overlap() const {
    return std::sqrt(cosine * cosine + sine * sine) + std::fabs(centrifugal[1]);
  }
  /// The largest overlap itself, [d_s], by bisection: where the approach ends.
  Real deepest_overlap(Class const& c) const {
    Real low = 0, high = duration;
    for (int n = 0; n < 50; ++n) {
      Real const middle = (low + high) / 2;
      (polar(c, middle).approach > 0 ? low : high) = middle;
    }
    return polar(c, low).overlap;
  }
  /// Largest relative speed, [d_s / tau_e].
  Real largest_speed(Class const& c) const { return normal_speed(c) + tangential_speed(c); }
  /// Largest force over mu, [d_s / tau_e^2]; share_i of it is that of disk i.
  Real largest_acceleration(Class const& c) const {
    return c.frequency02 * (largest_overlap() + pushed()) +
           c.rates.sliding * std::fabs(sliding) * stretch(c);
  }
  /// Largest distance between the relative motion and its straight continuation after the contact,
  /// [d_s]; share_i of it is that of disk i.
  Real largest_deviation(Class const& c) const {
    Real const l = tangential_speed(c), turn = l * duration * c.inverse_distance;
    Real const slid = std::fabs(last.angular - (constant + sliding));
    return std::max(largest_overlap(), -last.approach * duration) +
           duration * (slid + turn * (l + normal_speed(c)));
  }

 private:
  template <class T>
  struct Radial {
    T overlap, approach;
  };

  template <class T>
  Radial<T> radial(Class const& c, ContactPhase<T> const& p) const {
    Real const b = c.rates.damping, w = c.rates.frequency, a = c.rates.sliding;
    Radial<T> of{
        p.decay * (T(cosine) * p.cosine + T(sine) * p.sine) - T(centrifugal[0]),
        p.decay * (T(w * sine - b * cosine) * p.cosine - T(w * cosine + b * sine) * p.sine)};
    if (a == 0) return of;
    T const first = T(centrifugal[1]) * p.slide, second = T(centrifugal[2]) * p.slide * p.slide;
    return {of.overlap - (first + second), of.approach + T(a) * (first + T(2) * second)};
  }

  template <class T>
  PolarMotion<T> polar(Class const& c, ContactPhase<T> const& p, Radial<T> const& q) const {
    Real const a = c.rates.sliding, b = c.rates.damping, w = c.rates.frequency;
    Real const id = c.inverse_distance;
    auto const closed = [&](Real rate) {  // of the integral of exp(rate s)(P cos + R sin)
      Real const scale = 1 / (rate * rate + w * w);
      return Vec2<Real>{scale * (rate * cosine - w * sine), scale * (w * cosine + rate * sine)};
    };
    T lost = T(c.push[0] * centrifugal[0]) * p.time;
    T l(constant + sliding), path = T(constant + sliding) * p.time;
    T two_slides(0);
    if (a != 0) {
      two_slides = T(0.5) * p.slide_time * (T(1) + p.slide);
      lost +=
          T(c.push[1] * centrifugal[1]) * p.slide_time + T(c.push[2] * centrifugal[2]) * two_slides;
      l = T(constant) + T(sliding) * p.slide;
      path = T(constant) * p.time + T(sliding) * p.slide_time;
    }
    // integral of the overlap, from that of its equation
    T const sum = (T(approach) - q.approach + T(2 * b) * (T(overlap) - q.overlap) - lost) *
                  T(1 / c.frequency02);
    T path_of_overlap = l * sum;
    if (a != 0) {
      T const three_slides = T(1.0 / 3) * (p.slide_time + T(2) * p.slide * two_slides);
      auto const [f, g] = closed(-(a + b));
      T const fading =  // integral of exp(-a s) delta
          p.decay * p.slide * (T(f) * p.cosine + T(g) * p.sine) - T(f) -
          T(centrifugal[0]) * p.slide_time - T(centrifugal[1]) * two_slides -
          T(centrifugal[2]) * three_slides;
      path_of_overlap = T(constant) * sum + T(sliding) * fading;
      if constexpr (Rotates) {
        auto const [h, k] = closed(a - b);
        T const growing =  // exp(-a s) times the integral of exp(a s) delta
            p.decay * (T(h) * p.cosine + T(k) * p.sine) - T(h) * p.slide -
            T(centrifugal[0]) * p.slide_time - T(centrifugal[1]) * p.time * p.slide -
            T(centrifugal[2]) * p.slide * p.slide_time;
        T const more = T(sliding) * p.slide * sum - T(constant / 2) * growing;
        l += T(4 * a / 3 * id) * more;
        path += T(4 * id / 3) * (T(sliding) * fading - T(constant / 2) * sum - more);
      }
    }
    return {q.overlap, q.approach, l, turned(T(id) * (path + T(2 * id) * path_of_overlap))};
  }

  /// n at s = 0, turned by an angle.
  template <class T>
  Vec2<T> turned(T const& theta) const {
    auto const turn = sine_cosine(theta);
    return {turn.cosine * T(normal.x) - turn.sine * T(normal.y),
            turn.sine * T(normal.x) + turn.cosine * T(normal.y)};
  }
  series::SineCosine<Real> sine_cosine(Real x) const {
    if (std::fabs(x) < 1.0 / 64) return series::sine_cosine<4>(x);
    return {std::sin(x), std::cos(x)};
  }
  series::SineCosine<AtNodes> sine_cosine(AtNodes const& x) const {  // |x| < 1, few but slight
    bool const slight = (std::fabs(constant) + std::fabs(sliding)) * duration < 1.0 / 128;
    return slight ? series::sine_cosine<3>(x) : series::sine_cosine<9>(x);
  }

  Real pushed() const { return centrifugal[0] + std::fabs(centrifugal[1]) + centrifugal[2]; }
  Real stretch(Class const& c) const { return 1 + 5 * largest_overlap() * c.inverse_distance; }
  Real normal_speed(Class const& c) const {
    return c.frequency0 * largest_overlap() + 2 * c.rates.sliding * pushed();
  }
  Real tangential_speed(Class const& c) const {
    return std::max(std::fabs(constant + sliding), std::fabs(constant)) * stretch(c);
  }

  static ClosedContact with(Class const& c, PairMotion<Rotates> const& pair, bool fresh) {
    ClosedContact k;
    if constexpr (Rotates) k.spins = {pair.spin_i, pair.spin_j};
    Real const r = std::sqrt(dot(pair.separation, pair.separation));
    k.normal = (1 / r) * pair.separation;
    k.overlap = fresh ? 0 : std::max<Real>(c.distance - r, 0);
    k.approach = -dot(pair.velocity, k.normal);
    Real const l = cross(k.normal, pair.velocity) * (r * c.inverse_distance);
    Real const b = c.rates.damping, a = c.rates.sliding;
    k.constant = l;
    k.sliding = 0;
    k.centrifugal[1] = k.centrifugal[2] = 0;
    if (a != 0) {
      k.constant = 0;
      if constexpr (Rotates) {
        Real const half_roll = c.distance / 2 * (c.arm_i * pair.spin_i + c.arm_j * pair.spin_j);
        k.constant = Real(2.0 / 3) * (l + half_roll);
      }
      k.sliding = l - k.constant;
      k.centrifugal[1] = c.centrifugal_gain[1] * 2 * k.constant * k.sliding;
      k.centrifugal[2] = c.centrifugal_gain[2] * k.sliding * k.sliding;
    }
    k.centrifugal[0] = c.centrifugal_gain[0] * k.constant * k.constant;
    k.cosine = k.overlap + (k.centrifugal[0] + (k.centrifugal[1] + k.centrifugal[2]));
    k.sine = (k.approach + b * k.cosine - a * (k.centrifugal[1] + 2 * k.centrifugal[2])) *
             c.inverse_frequency;
    return k;
  }

  void end_at_once(PairMotion<Rotates> const& pair) {
    duration = 0;
    last = first();
    end = pair;
  }

  /// Finds the end of a contact from its beginning: nearly half a period later.
  void find_end(Class const& c) {
    Real const w = c.rates.frequency;
    auto q = radial(c, c.end);
    Real early = 0;  // before half_period
    if (q.approach < 0) {
      Real const first = q.overlap / q.approach;
      Real const l = constant + sliding * c.end.slide;
      Real const curvature = -c.frequency02 * q.overlap - 2 * c.rates.damping * q.approach -
                             l * l * c.inverse_distance;
      early = first * (1 + curvature * first / (2 * q.approach));
    }
    if (q.approach < 0) {
      for (int n = 0; n < 8; ++n) {
        Real const slight = std::fabs(early) * c.rates.largest() / ContactRates::slight;
        if (!(slight < 1)) break;
        auto const p = c.rates.slightly_earlier(c.end, early, slight < 1.0 / 16);
        q = radial(c, p);
        Real const change = q.overlap / q.approach;
        if (std::fabs(change) * w < 1e-9) return end_at(c, c.rates.barely_earlier(p, change));
        early += change;
      }
    }
    search_end(c);
  }

  /// Finds the end from any phase, by Newton's method in a bracket. Without the centrifugal term,
  /// which pulls the disks apart, the overlap would be 0 at `high`. With it the overlap is not
  /// above 0 there, and it has been 0 once.
  void search_end(Class const& c) {
    Real const w = c.rates.frequency;
    Real const swing = (approach + c.rates.damping * overlap) * c.inverse_frequency;
    Real low = 0, high = (std::numbers::pi - std::atan2(overlap, swing)) * c.inverse_frequency;
    Real s = high;
    if (overlap == 0) {  // a grazing contact is a chord
      Real const l = constant + sliding;
      s = std::min(high, 2 * approach * c.distance / (l * l + 1e-300));
    }
    auto p = c.rates.phase(s);
    for (int n = 0; n < 100; ++n) {
      auto const q = radial(c, p);
      (q.overlap > 0 ? low : high) = s;
      Real const change = q.overlap / q.approach;
      if (q.approach < 0 && std::fabs(change) * w < 1e-9) {
        p = c.rates.barely_earlier(p, change);
        break;
      }
      s = q.approach < 0 ? s - change : (low + high) / 2;
      if (!(s > low && s < high)) s = (low + high) / 2;
      p = c.rates.phase(s);
    }
    end_at(c, p);
  }

  void end_at(Class const& c, ContactPhase<Real> const& p) {
    auto const q = radial(c, p);
    duration = p.time;
    last = polar(c, p, Radial<Real>{0, std::min<Real>(q.approach, 0)});
    end = motion(c, last);
  }
};

}  // namespace bagnold
