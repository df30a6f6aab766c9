// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

/// phi = 0.82, Q = 1, 1e-4, beside two stages (docs/long_steps.md): v_N_rms +26(2)% in CD with a
/// step of 1.6, +25(1)% in CD_rot with 1.4; tau_dur +0.8(4)% and +9.2(7)%.
std::optional<Warning> implicit_contacts(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  auto const scheme = scheme_of(scene);
  double const dt = finished.run.plan.time_step;
  if (!scene.measure.contacts || !is_implicit(scheme) ||
      dt <= rule_time_step(scene, default_scheme))
    return {};
  bool const rolls = scene.rotates();
  return Warning{
      "implicit_contacts",
      {{"time_step", dt}},
      fmt::format("{} with a step of {} tau_e leaves velocities along the line of centres in "
                  "contact too large{}: at phi = 0.82, 1e-4 steps of 1.4 had v_N_rms 25% too "
                  "large{}",
                  scheme, dt, rolls ? " and misses short contacts of disks that roll" : "",
                  rolls ? ", tau_dur 9% too long and nu_coll 9% too small" : ""),
      "set integration.scheme = \"two-stage-leapfrog\"",
      by_scheme(default_scheme, "two-stages")};
}

}  // namespace bagnold
