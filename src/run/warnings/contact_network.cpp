// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/stability.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> contact_network(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  auto const scheme = scheme_of(scene);
  double const taken = finished.run.plan.time_step;
  double const borne = dense_flow_time_step(scene, scheme);
  if (taken <= borne) return {};
  double const sure = largest_stable_time_step(scene, scheme);
  return Warning{
      "contact_network",
      {{"time_step", taken}, {"dense_flow_time_step", borne}, {"largest_stable_time_step", sure}},
      fmt::format("integration.time_step = {} is above {:.3g}, up to which {} was seen to bear the "
                  "damping of a dense flow (Z = 3.5): contacts of disks with several may grow, "
                  "unseen in averages",
                  taken, borne, scheme),
      fmt::format("take at most {:.3g}, which six contacts a disk bear, or halve it and compare",
                  sure),
      changed_run("integration.time_step", given_step(finished.run, sure, 3))};
}

}  // namespace bagnold
