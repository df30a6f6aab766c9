// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> pressure_not_held(FinishedRun const& finished) {
  double const held = finished.run.scene.shear.pressure;
  auto const* found = finished.of("p");
  if (!found || !found->estimate.all.mean) return {};
  double const p = *found->estimate.all.mean;
  auto const error = found->estimate.all.error;
  double const most =
      error ? most_not_held * held + standard_errors * *error : most_not_held_unsure * held;
  if (std::abs(p - held) <= most) return {};
  return Warning{"pressure_not_held",
                 {{"pressure", held}, {"p", p}, {"error", error.value_or(0)}},
                 fmt::format("p is {:.3g} m/tau_e^2 where {:.3g} is to be held: the box has not "
                             "come to its size",
                             p, held),
                 "a longer shear.strain, a smaller shear.response, or a disks.packing_fraction "
                 "nearer to that of the flow",
                 longer_run(finished.run, 4)};
}

}  // namespace bagnold
