// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/ladder.hpp"
#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> implicit_inertia(FinishedRun const& finished) {
  auto const scheme = scheme_of(finished.run.scene);
  if (!is_implicit(scheme)) return {};
  double const kinetic = finished.mean("p_kin") / finished.mean("p");
  double const least = least_inertia(finished.run.scene);
  if (!(kinetic > least)) return {};
  return Warning{
      "implicit_inertia",
      {{"p_kin_share", kinetic}},
      fmt::format("p_kin/p = {:.2g} (above {:g}): inertia has a part in this flow, and {} with a "
                  "step of {} tau_e is for motions that damping alone decides",
                  kinetic, least, scheme, finished.run.plan.time_step),
      "set integration.scheme = \"auto\", which steps through collisions",
      by_scheme(automatic, "auto")};
}

}  // namespace bagnold
