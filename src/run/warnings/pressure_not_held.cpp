// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> pressure_not_held(FinishedRun const& finished) {
  double const held = finished.run.scene.shear.pressure;
  auto const* found = finished.of("p");
  if (!found || !found->estimate.all.mean) return {};
  auto const& p = found->estimate.all;
  if (is_held(p, held)) return {};
  return Warning{"pressure_not_held",
                 {{"pressure", held}, {"p", *p.mean}, {"error", p.error.value_or(0)}},
                 fmt::format("p is {:.3g} m/tau_e^2 where {:.3g} is to be held: the box has not "
                             "come to its size",
                             *p.mean, held),
                 "a longer shear.strain, a smaller shear.response, or a disks.packing_fraction "
                 "nearer to that of the flow",
                 longer_run(finished.run, 4)};
}

}  // namespace bagnold
