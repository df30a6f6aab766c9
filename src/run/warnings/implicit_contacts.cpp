// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

/// CD_rot, phi = 0.82, 1e-4, a step of 1.4, beside two stages: tau_dur +10.7(1.0)%, nu_coll
/// -9.8(1.0)%; CD, a step of 1.6: +0.3(1.4)% and -0.5(1.3)%.
std::optional<Warning> implicit_contacts(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  auto const scheme = scheme_of(scene);
  double const dt = finished.run.plan.time_step;
  if (!scene.measure.contacts || !scene.rotates() || !is_implicit(scheme) ||
      dt <= rule_time_step(scene, default_scheme))
    return {};
  return Warning{
      "implicit_contacts",
      {{"time_step", dt}},
      fmt::format("{} with a step of {} tau_e misses short contacts of disks that roll: at phi = "
                  "0.82, 1e-4 a step of 1.4 had tau_dur 11% too long and nu_coll 10% too small",
                  scheme, dt),
      "set integration.scheme = \"two-stage-leapfrog\"",
      by_scheme(default_scheme, "two-stages")};
}

}  // namespace bagnold
