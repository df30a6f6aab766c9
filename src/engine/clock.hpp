// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/box/shear_since.hpp"
#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold {

/// Time and strain from an integer step count, so that rounding does not add up over a long run.
///
/// The offset of the images is reduced modulo L_x only at list builds; in between it grows on.
struct Clock {
  double strain_rate;     ///< gammadot, [1 / tau_e]
  double time_step;       ///< dt, [tau_e]
  double box_length;      ///< L_x, [d_s]
  double initial_offset;  ///< gamma L_y modulo L_x at step 0, [d_s]
  double initial_time;    ///< at step 0, [tau_e]
  double box_aspect = 1;  ///< L_y / L_x

  KOKKOS_FUNCTION double time(std::int64_t step) const {
    return (DoubleDouble{initial_time} + exact_product(time_step, static_cast<double>(step)))
        .rounded();
  }

  /// Strain since step 0.
  KOKKOS_FUNCTION double strain(std::int64_t step) const {
    return (step_strain() * static_cast<double>(step)).rounded();
  }

  KOKKOS_FUNCTION double strain_between(std::int64_t from, std::int64_t to) const {
    return strain(to - from);
  }

  KOKKOS_FUNCTION ShearSince since(std::int64_t build) const {
    return shear_since(quotient(initial_offset, box_length) +
                           step_strain() * box_aspect * static_cast<double>(build),
                       step_strain(), box_length, box_aspect);
  }

  /// x of the image above at `step`, [d_s]; in [0, L_x) at step = build.
  KOKKOS_FUNCTION double offset(std::int64_t step, std::int64_t build) const {
    return since(build).offset(step - build);
  }

  /// The box at `step`, its offset counted from a list build.
  KOKKOS_FUNCTION ShearedBox box(std::int64_t step, std::int64_t build) const {
    return {box_length, offset(step, build), strain_rate, box_aspect * box_length};
  }

 private:
  KOKKOS_FUNCTION DoubleDouble step_strain() const { return exact_product(strain_rate, time_step); }
};

}  // namespace bagnold
