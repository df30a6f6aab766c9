// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "kernels/physics/double_double.hpp"
#include "src/config/ramp.hpp"

namespace bagnold {

/// Strain rate over the steps of a run: constant, or that of a ramp, which changes between steps.
class StrainRates {
 public:
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

  /// Steps at one rate.
  struct Stretch {
    std::int64_t begin, end;  ///< steps begin .. end - 1
    double rate;              ///< [1/tau_e]
  };

  StrainRates(double rate) : rate_(rate) {}
  StrainRates(Ramp const& ramp) : ramp_(ramp) {}

  /// Stretch of a step. Nothing changes after the last step of a ramp.
  Stretch at(std::int64_t step) const;

  /// Strain from step 0 to the beginning of a stretch.
  DoubleDouble strain_before(Stretch const& stretch) const;

 private:
  double rate_ = 0;
  std::optional<Ramp> ramp_;
};

/// Strain rates of a scene whose protocol has one rate, or is a ramp.
StrainRates strain_rates(Scene const& scene);

}  // namespace bagnold
