// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "kernels/physics/double_double.hpp"

namespace bagnold {

/// Strain rates of a run that changes its rate between steps, known from the step alone.
class RateSchedule {
 public:
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

  /// Steps at one rate.
  struct Stretch {
    std::int64_t begin, end;  ///< steps begin .. end - 1
    double rate;              ///< [1/tau_e]
  };

  virtual ~RateSchedule() = default;

  /// Stretch of a step. The last one never ends.
  virtual Stretch at(std::int64_t step) const = 0;

  /// Strain from step 0 to the beginning of a stretch.
  virtual DoubleDouble strain_before(Stretch const& stretch) const = 0;

  /// True if velocities and spins are scaled with the rate where it changes, P2 Eqs. (40)-(41).
  /// Otherwise they keep their excess over the mean flow: v - gammadot y x^ and thetadot +
  /// gammadot/2.
  virtual bool scales_motions() const = 0;
};

}  // namespace bagnold
