// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kernels/physics/sums/sums.hpp"
#include "src/run/collisions.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// Collisions of a disk in a ramp, which has no average Z: contacts of all its windows, over its
/// time.
double in_ramp(Run const& run) {
  auto const& plan = run.plan;
  auto const first = static_cast<std::size_t>(plan.discarded_windows);
  auto const begin = plan.discarded_windows == 0 ? 0 : plan.window_end(plan.discarded_windows - 1);
  double contacts = 0;
  for (auto const& replica : run.replicas) {
    auto const& windows = replica.measurement.windows;
    if (windows.size() > first)
      contacts += windows.mean(first, windows.size())[SumColumns::contacts] /
                  static_cast<double>(run.scene.disks.count * run.scene.disks.replicas);
  }
  double const time = plan.time_step * static_cast<double>(plan.steps - begin);
  return collisions_per_disk(run.scene, contacts, run.scene.shear.strain_rate * time);
}

}  // namespace

std::optional<Warning> few_collisions(FinishedRun const& finished) {
  bool const is_ramp = finished.run.plan.ramp.has_value();
  double const collisions = is_ramp ? in_ramp(finished.run)
                                    : collisions_per_disk(finished.run.scene, finished.mean("Z"),
                                                          finished.measured_strain());
  if (!(collisions < fewest_collisions)) return {};
  auto const where =
      is_ramp ? "in the ramp"
              : fmt::format("in the measured strain of {:.3g}", finished.measured_strain());
  return Warning{
      "few_collisions",
      {{"collisions_per_disk", collisions}},
      fmt::format("a disk collides {:.2g} times at most {}; it takes {:.0f} to forget the start",
                  collisions, where, fewest_collisions),
      is_ramp ? "take a slower ramp (shear.ramp_rate), or denser disks" : "make the run longer",
      is_ramp ? "" : longer_run(finished.run, 1.5 * fewest_collisions / collisions)};
}

}  // namespace bagnold
