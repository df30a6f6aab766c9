// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/physics/closed_form/series.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// A phase of a contact: the numbers from which all others follow.
template <class T>
struct ContactPhase {
  T time;          ///< s, since the reference instant of the contact, [tau_e]
  T decay;         ///< exp(-b s)
  T cosine, sine;  ///< of omega s
  T slide;         ///< exp(-a s)
  T slide_time;    ///< (1 - exp(-a s))/a, [tau_e]; s where a = 0
};

/// Rates of a contact class, [1 / tau_e].
struct ContactRates {
  Real damping;    ///< b
  Real frequency;  ///< omega
  Real sliding;    ///< a

  Real largest() const { return std::max({damping, frequency, sliding}); }

  ContactPhase<Real> phase(Real s) const {
    ContactPhase<Real> p{
        s, std::exp(-damping * s), std::cos(frequency * s), std::sin(frequency * s), 1, s};
    if (sliding == 0) return p;
    Real const lost = -std::expm1(-sliding * s);
    p.slide = 1 - lost;
    p.slide_time = lost / sliding;
    return p;
  }

  /// Bound of slight times: largest() times the time is below this.
  static constexpr Real slight = 1.0 / 64;

  /// Phases slightly earlier. very: a 16th of `slight`, at most.
  template <class T>
  ContactPhase<T> slightly_earlier(ContactPhase<T> const& p, T const& by, bool very) const {
    return very ? earlier<2, 4>(p, by) : earlier<4, 7>(p, by);
  }

  /// Phase earlier by a time whose product with largest() has a negligible square.
  ContactPhase<Real> barely_earlier(ContactPhase<Real> const& p, Real by) const {
    return {p.time - by,
            p.decay + damping * by * p.decay,
            p.cosine + frequency * by * p.sine,
            p.sine - frequency * by * p.cosine,
            p.slide + sliding * by * p.slide,
            p.slide_time - p.slide * by};
  }

  /// Phases earlier by times whose products with largest() are below 2.
  template <class T>
  ContactPhase<T> earlier(ContactPhase<Real> const& p, T const& by) const {
    return earlier(p, by, series::sine_cosine<11>(T(frequency) * by), growth(T(damping) * by),
                   sliding == 0 ? T(0) : growth(T(sliding) * by));
  }

 private:
  template <int of_turn, int of_growth, class T>
  ContactPhase<T> earlier(ContactPhase<T> const& p, T const& by) const {
    return earlier(p, by, series::sine_cosine<of_turn>(T(frequency) * by),
                   series::growth<of_growth>(T(damping) * by),
                   sliding == 0 ? T(0) : series::growth<of_growth>(T(sliding) * by));
  }

  /// exp(x) - 1, |x| < 2.
  template <class T>
  static T growth(T const& x) {
    T const quarter = series::growth<12>(T(0.25) * x);
    T const half = quarter * (T(2) + quarter);
    return half * (T(2) + half);
  }

  template <class T, class Of>
  ContactPhase<T> earlier(ContactPhase<Of> const& p, T const& by, series::SineCosine<T> const& turn,
                          T const& decayed, T const& slid) const {
    ContactPhase<T> q;
    q.time = T(p.time) - by;
    q.decay = T(p.decay) + T(p.decay) * decayed;
    q.cosine = T(p.cosine) * turn.cosine + T(p.sine) * turn.sine;
    q.sine = T(p.sine) * turn.cosine - T(p.cosine) * turn.sine;
    T const more = T(p.slide) * slid;
    q.slide = T(p.slide) + more;
    q.slide_time = sliding == 0 ? q.time : T(p.slide_time) - more * T(1 / sliding);
    return q;
  }
};

}  // namespace bagnold
