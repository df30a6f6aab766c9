// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/cpu/events/tournament.hpp"

namespace bagnold::events {

/// How far two disks are from touching, f = r - d, and df/dt.
struct Gap {
  Real width;  ///< [d_s]
  Real rate;   ///< [d_s / tau_e]
};

/// When a gap closes between two times, or `never`. gap(t): of paths that are smooth there;
/// acceleration: bound of the relative one. As f'' is not below -a, nothing can happen before the
/// root h of f + f' h - a h^2/2 = 0, and the search goes on from there.
template <class GapAt>
Real first_touch(GapAt const& gap, Real from, Real until, Real acceleration) {
  constexpr Real share = 1e-10;  // of the time between, that counts as none
  constexpr int most = 400;
  Real const a = acceleration + 1e-300, least = share * (until - from);
  Real time = from;
  for (int n = 0; n < most; ++n) {
    auto [width, rate] = gap(time);
    if (width <= 0) {
      if (rate < 0) return time;
      width = 0;
    }
    Real const root = std::sqrt(rate * rate + 2 * a * width);
    Real const wait = rate < 0 ? 2 * width / (root - rate) : (rate + root) / a;
    if (rate < 0 && wait < least) return time + wait <= until ? time + wait : never;
    time += wait > least ? wait : least;
    if (time >= until) return never;
  }
  return time;
}

}  // namespace bagnold::events
