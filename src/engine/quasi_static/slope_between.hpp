// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "src/engine/quasi_static/near_pairs.hpp"

namespace bagnold::quasi_static {

/// A trial along a direction d: the slope R.d there, and the overlaps of all pairs of the list.
struct Trial {
  Real share;                 ///< of d
  Real slope;                 ///< [m d_s^2 / tau_e^2]
  std::vector<Real> overlap;  ///< d_ij - r_ij, [d_s]
};

/// Slope between two trials, with overlaps linear from one to the other: the springs of pairs that
/// come into contact or out of it, and a linear rest,
///
///     R.d (s) = A + B s + sum_ij (k_e/d_ij^2) max(0, delta_ij(s)) d delta_ij/ds
class SlopeBetween {
 public:
  SlopeBetween(Trial const& low, Trial const& high, std::vector<NearPair> const& pairs)
      : low_(low.slope), high_(high.slope) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      Real const overlap = low.overlap[k], change = high.overlap[k] - overlap;
      if ((overlap > 0) == (high.overlap[k] > 0)) continue;
      Real const distance = pairs[k].distance;
      turning_.push_back(
          {overlap, change, change / (distance * distance * (high.share - low.share))});
      low_ -= turning_.back().slope(0);
      high_ -= turning_.back().slope(1);
    }
  }

  /// Zero of the slope, as a share of the way between the trials; the slope increases.
  Real zero() const {
    Real low = 0, high = 1;
    for (int halvings = 0; halvings < 60; ++halvings) {
      Real const middle = (low + high) / 2;
      (at(middle) > 0 ? high : low) = middle;
    }
    return (low + high) / 2;
  }

 private:
  struct Turning {
    Real overlap, change;
    Real factor;  ///< (k_e/d_ij^2) d delta_ij/ds
    Real slope(Real part) const { return factor * std::max(Real(0), overlap + part * change); }
  };

  Real at(Real part) const {
    Real sum = low_ + part * (high_ - low_);
    for (auto const& pair : turning_) sum += pair.slope(part);
    return sum;
  }

  Real low_, high_;  ///< of the rest
  std::vector<Turning> turning_;
};

}  // namespace bagnold::quasi_static
