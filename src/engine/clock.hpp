// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/box/shear_since.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Time and strain from an integer step count, so that rounding does not add up over a long run.
///
/// The offset of the images is reduced modulo L_x only at list builds; in between it keeps growing.
/// Where the strain rate changes between steps, a clock belongs to the steps at one rate and holds
/// the strain before them; marks were set by it or by clocks of earlier steps.
struct Clock {
  double strain_rate;            ///< gammadot, [1 / tau_e]
  double time_step;              ///< dt, [tau_e]
  double box_length;             ///< L_x, [d_s]
  double initial_offset;         ///< gamma L_y modulo L_x at step 0, [d_s]
  double initial_time;           ///< at step 0, [tau_e]
  double box_aspect = 1;         ///< L_y / L_x
  std::int64_t rate_step = 0;    ///< from which on the rate is this one
  DoubleDouble strain_before{};  ///< from step 0 to rate_step

  KOKKOS_FUNCTION double time(std::int64_t step) const {
    return (DoubleDouble{initial_time} + exact_product(time_step, static_cast<double>(step)))
        .rounded();
  }

  /// Strain since step 0.
  KOKKOS_FUNCTION double strain(std::int64_t step) const { return exact_strain(step).rounded(); }

  KOKKOS_FUNCTION ShearMark mark(std::int64_t step) const {
    return {step, exact_strain(step),
            turns_in_box(quotient(initial_offset, box_length) + strain_before * box_aspect +
                             step_strain() * box_aspect * static_cast<double>(step - rate_step),
                         box_length)};
  }

  KOKKOS_FUNCTION ShearSince since(ShearMark const& mark) const {
    if (mark.step >= rate_step)
      return {mark.turns, {}, mark.step, step_strain(), box_length, box_aspect};
    return {mark.turns, strain_before + mark.strain * -1.0, rate_step, step_strain(), box_length,
            box_aspect};
  }

  KOKKOS_FUNCTION double strain_since(ShearMark const& mark, std::int64_t step) const {
    return since(mark).strain(step);
  }

  /// x of the image above at `step`, [d_s]; in [0, L_x) at the mark.
  KOKKOS_FUNCTION double offset(std::int64_t step, ShearMark const& mark) const {
    return since(mark).offset(step);
  }

  /// The box at a mark.
  KOKKOS_FUNCTION ShearedBox box(ShearMark const& mark) const {
    return {box_length, (mark.turns * box_length).rounded(), strain_rate, box_aspect * box_length};
  }

  /// Offset and box at `step`, counted from a step at the same rate.
  KOKKOS_FUNCTION double offset(std::int64_t step, std::int64_t build) const {
    return offset(step, mark(build));
  }
  KOKKOS_FUNCTION double strain_between(std::int64_t from, std::int64_t to) const {
    return (step_strain() * static_cast<double>(to - from)).rounded();
  }
  KOKKOS_FUNCTION ShearedBox box(std::int64_t step, std::int64_t build) const {
    return box(step, mark(build));
  }

  /// The box at `step`, its offset counted from a mark.
  KOKKOS_FUNCTION ShearedBox box(std::int64_t step, ShearMark const& mark) const {
    return {box_length, offset(step, mark), strain_rate, box_aspect * box_length};
  }

  /// Writes box, time and rate at a step into a state. The step is at the present rate.
  void tell(State& state, std::int64_t step) const {
    state.box_length = box_length;
    state.box_aspect = box_aspect;
    state.offset = offset(step, step);
    state.time = time(step);
    state.strain_rate = strain_rate;
  }

 private:
  KOKKOS_FUNCTION DoubleDouble step_strain() const { return exact_product(strain_rate, time_step); }

  KOKKOS_FUNCTION DoubleDouble exact_strain(std::int64_t step) const {
    return strain_before + step_strain() * static_cast<double>(step - rate_step);
  }
};

}  // namespace bagnold
