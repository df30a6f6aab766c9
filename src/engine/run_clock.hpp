// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/rate_change.hpp"
#include "src/config/strain_rates.hpp"
#include "src/engine/clock.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold {

/// Clock of the present step of a run, and of other steps. It depends on the step alone, so
/// interruptions of a run do not matter.
struct RunClock : Clock {
  StrainRates rates;
  std::int64_t rate_end = StrainRates::never;  ///< step at which the rate changes

  RunClock(StrainRates const& all, double dt, Snapshot const& snapshot)
      : Clock{0,
              dt,
              snapshot.state.box_length,
              snapshot.initial_offset,
              snapshot.initial_time,
              snapshot.state.box_aspect},
        rates(all) {
    move_to(snapshot.step);
  }

  /// Clock of another step.
  Clock at(std::int64_t step) const {
    Clock clock = *this;
    auto const stretch = rates.at(step);
    clock.strain_rate = stretch.rate;
    clock.rate_step = stretch.begin;
    clock.strain_before = rates.strain_before(stretch);
    return clock;
  }

  void move_to(std::int64_t step) {
    static_cast<Clock&>(*this) = at(step);
    rate_end = rates.at(step).end;
  }

  /// Moves to the next rate at rate_end. Returns the change of all motions there.
  RateChange change_rate() {
    double const before = strain_rate;
    move_to(rate_end);
    if (rates.scales_motions()) return {strain_rate / before, 0};
    return {1, strain_rate - before};
  }
};

}  // namespace bagnold
