// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// What a step of implicit damping did to contacts, beside two stages.
struct Seen {
  double step;       ///< [tau_e]
  int v_N, tau_dur;  ///< v_N_rms and tau_dur too large by, per cent
  int nu_coll;       ///< too small by, per cent
};

/// phi = 0.82, Q = 1, 1e-4, CD and CD_rot (docs/long_steps.md).
Seen seen(bool rotates) { return rotates ? Seen{1.8, 36, 11, 10} : Seen{1.6, 21, 9, 8}; }

}  // namespace

std::optional<Warning> implicit_contacts(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  auto const scheme = scheme_of(scene);
  double const dt = finished.run.plan.time_step;
  if (!scene.measure.contacts || !is_implicit(scheme) ||
      dt <= rule_time_step(scene, default_scheme))
    return {};
  auto const [step, v_N, tau_dur, nu_coll] = seen(scene.rotates());
  return Warning{
      "implicit_contacts",
      {{"time_step", dt}},
      fmt::format(
          "{} with a step of {} tau_e leaves velocities along the line of centres in "
          "contact too large and misses short contacts: at phi = 0.82, 1e-4 steps of {} had "
          "v_N_rms {}% too large, tau_dur {}% too long and nu_coll {}% too small",
          scheme, dt, step, v_N, tau_dur, nu_coll),
      "set integration.scheme = \"two-stage-leapfrog\"",
      by_scheme(default_scheme, "two-stages")};
}

}  // namespace bagnold
