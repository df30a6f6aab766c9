// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace bagnold {

/// Time and strain from an integer step count, so that rounding does not add up over a long run.
///
/// The offset of the images is reduced modulo L only at list builds; in between it grows on.
struct Clock {
  double strain_rate;     ///< gammadot, [1 / tau_e]
  double time_step;       ///< dt, [tau_e]
  double box_length;      ///< L, [d_s]
  double initial_offset;  ///< gamma L modulo L at step 0, [d_s]
  double initial_time;    ///< at step 0, [tau_e]

  double time(std::int64_t step) const {
    return static_cast<double>(initial_time + static_cast<long double>(step) * time_step);
  }

  /// Strain since step 0.
  double strain(std::int64_t step) const { return static_cast<double>(exact_strain(step)); }

  double strain_between(std::int64_t from, std::int64_t to) const { return strain(to - from); }

  /// x of the image above at `step`, [d_s]; in [0, L) at step = build.
  double offset(std::int64_t step, std::int64_t build) const {
    long double const length = box_length;
    long double turns = initial_offset / length + exact_strain(build);
    turns -= std::floor(turns);
    double const at_build = static_cast<double>(turns * length);
    return at_build < box_length
               ? static_cast<double>((turns + exact_strain(step - build)) * length)
               : static_cast<double>(exact_strain(step - build) * length);
  }

 private:
  long double exact_strain(std::int64_t steps) const {
    return static_cast<long double>(steps) * (static_cast<long double>(strain_rate) * time_step);
  }
};

}  // namespace bagnold
