// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Flight of disks within a lookahead whose strain rate may change between steps.
///
/// Velocities and spins scale with the rate (P2 Eqs. 40-41), as does the flow. A disk that touches
/// nothing stays on a straight line,
///
///     r(s) = r(0) + v(0) t(s),   v(s) = q(s) v(0),
///     t(s) = dt sum_(s' < s) q(s'),   q(s) = gammadot(s)/gammadot(0),
///
/// s: steps from the start of the lookahead. At a constant rate q = 1 and t = s dt.
class FlightTimes {
 public:
  void clear(Real time_step) {
    time_step_ = time_step;
    scale_.clear();
    time_.assign(1, 0);
  }

  /// Adds the rate of the next step, for lookaheads with more than one rate: of step 0, 1, .. and
  /// of the step after the last.
  void add(Real scale) {
    if (!scale_.empty()) time_.push_back(time_.back() + scale_.back() * time_step_);
    scale_.push_back(scale);
  }

  bool at_one_rate() const { return scale_.empty(); }

  /// q of a step.
  Real scale(std::int64_t step) const { return at_one_rate() ? 1 : scale_[index(step)]; }

  /// t of a step, [tau_e].
  Real time(std::int64_t step) const {
    return at_one_rate() ? static_cast<Real>(step) * time_step_ : time_[index(step)];
  }

  /// Growth of q from a step to a later one; and the time t between them at the rate of `from`.
  Real scale(std::int64_t from, std::int64_t to) const {
    return at_one_rate() ? 1 : scale_[index(to)] / scale_[index(from)];
  }
  Real time(std::int64_t from, std::int64_t to) const {
    return at_one_rate() ? static_cast<Real>(to - from) * time_step_
                         : (time_[index(to)] - time_[index(from)]) / scale_[index(from)];
  }

  /// Upper bound of the time of `steps` steps from a step on, at its rate.
  Real longer_than(std::int64_t from, std::int64_t steps) const {
    return at_one_rate() ? time_step_ * static_cast<Real>(steps + 1)
                         : time(from, from + steps) + time_step_;
  }

  /// Number of steps that begin up to `time` after `from`, at its rate, without `from` itself.
  /// Beyond the lookahead it is one more than the lookahead has.
  Real steps_until(std::int64_t from, Real time) const {
    if (at_one_rate()) return std::floor(time / time_step_);
    Real const until = time_[index(from)] + time * scale_[index(from)];
    auto const begun = std::upper_bound(time_.begin(), time_.end(), until) - time_.begin() - 1;
    return static_cast<Real>(begun + (until > time_.back()) - from);
  }

 private:
  static std::size_t index(std::int64_t step) { return static_cast<std::size_t>(step); }

  Real time_step_ = 0;  ///< dt, [tau_e]
  std::vector<Real> scale_, time_;
};

}  // namespace bagnold
