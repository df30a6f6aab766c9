// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "kernels/physics/laws/contact.hpp"
#include "src/config/errors.hpp"
#include "src/engine/clock.hpp"
#include "src/state/state.hpp"

/// Errors of engines that cannot continue, with what to do about them.
namespace bagnold::failure {

inline std::string where(Clock const& clock, std::int64_t step) {
  return fmt::format("step {} (strain {:.6g})", step, clock.strain(step));
}

[[noreturn]] inline void too_fast(Clock const& clock, std::int64_t step, std::size_t disk,
                                  double moved, double skin) {
  throw NumericalError(
      fmt::format("{}: disk {} moves {:.3g} d_s against the mean flow in one step, more than the "
                  "neighbour list's "
                  "skin of {:.3g} d_s allows; take a smaller integration.time_step or a larger "
                  "integration.skin",
                  where(clock, step), disk, moved, skin));
}

/// Throws where a motion is NaN.
inline void check_finite(Clock const& clock, std::int64_t step, State const& state) {
  for (std::size_t i = 0; i < state.count(); ++i)
    if (!std::isfinite(state.position[i][0] + state.position[i][1] + state.velocity[i][0] +
                       state.velocity[i][1]))
      throw NumericalError(fmt::format(
          "{}: the motion of disk {} is not a finite number; take a smaller integration.time_step",
          where(clock, step), i));
}

[[noreturn]] inline void too_deep(Clock const& clock, std::int64_t step, std::size_t disk,
                                  double overlap) {
  throw NumericalError(fmt::format(
      "{}: disk {} overlaps a neighbour by {:.1f}% (limit {:.0f}%), too soft for a "
      "grain; take a smaller strain rate (where they are held, shear.stress or shear.pressure) or "
      "disks.packing_fraction, or with steps a smaller integration.time_step",
      where(clock, step), disk, 100 * overlap, 100 * largest_relative_overlap));
}

}  // namespace bagnold::failure
