// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/vec2.hpp"
#include "src/config/strain_rates.hpp"

namespace bagnold::events {

/// Ends of steps on the clock of events. That clock goes with the strain, in units of the rate at
/// step 0:
///
///     dtau = (gammadot/gammadot_0) dt
///
/// Where the rate changes, velocities change with it (P2 Eqs. 40-41), so disks that fly keep their
/// lines and their velocities in tau. At one rate tau is the time.
class StepTimes {
 public:
  StepTimes(StrainRates const& rates, Real time_step);

  Real time_step() const { return time_step_; }          ///< dt, [tau_e]
  Real unit_rate() const { return unit_rate_; }          ///< gammadot_0, [1 / tau_e]
  Real speed() const { return speed_; }                  ///< gammadot/gammadot_0 at present
  std::int64_t counted_from() const { return origin_; }  ///< the step at which tau is 0

  /// Counts from a step on.
  void count_from(std::int64_t step);
  /// Takes the rate from a step on, up to its next change.
  void move_to(std::int64_t step);

  /// End of a counted step at the present rate.
  Real time(std::int64_t step) const {
    return step == last_ ? end_ : base_ + pace_ * static_cast<Real>(step - first_);
  }
  /// First step at the present rate that ends at a time, or after it.
  std::int64_t step_at(Real time) const;
  /// Last step that ends within a strain from the origin, 1 at least.
  std::int64_t last_within(Real strain) const;

  /// tau between two steps of the run, whatever the rates in between.
  Real between(std::int64_t from, std::int64_t to) const;

  StrainRates const& rates() const { return rates_; }

 private:
  void find_base();
  DoubleDouble strain(std::int64_t step) const;

  StrainRates rates_;
  Real time_step_, unit_rate_, speed_ = 1;
  std::int64_t origin_ = 0, at_ = 0;
  Real base_ = 0, pace_ = 0, end_ = 0;  ///< tau of step first_, of a step, and of step last_
  std::int64_t first_ = 0, last_ = StrainRates::never;  ///< counted
};

}  // namespace bagnold::events
