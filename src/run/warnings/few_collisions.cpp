// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <string>

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

/// Collisions of a disk in all windows of a run by pieces, whose lengths differ.
double in_pieces(Run const& run) {
  double contacts = 0;
  for (auto const& replica : run.replicas)
    for (std::size_t w = 0; w < replica.measurement.windows.size(); ++w) {
      auto const at = static_cast<std::int64_t>(w);
      contacts += replica.measurement.windows.mean(w, w + 1)[SumColumns::contacts] *
                  static_cast<double>(run.plan.window_end(at) - run.plan.window_begin(at));
    }
  auto const disks = static_cast<double>(run.scene.disks.count * run.scene.disks.replicas);
  return collisions_of(run.scene, contacts / disks * run.plan.time_step);
}

Warning warning_of(double collisions, std::string const& where, std::string const& remedy,
                   std::string const& command = "") {
  return {
      "few_collisions",
      {{"collisions_per_disk", collisions}},
      fmt::format("a disk collides {:.2g} times at most {}; it takes {:.0f} to forget the start",
                  collisions, where, fewest_collisions),
      remedy,
      command};
}

}  // namespace

std::optional<Warning> few_collisions(FinishedRun const& finished) {
  auto const& run = finished.run;
  if (run.plan.ramp) {
    if (double const found = in_ramp(run); found < fewest_collisions)
      return warning_of(found, "in the ramp",
                        "take a slower ramp (shear.ramp_rate), or denser disks");
    return {};
  }
  if (run.plan.pieces) {
    if (double const found = in_pieces(run); found < fewest_collisions)
      return warning_of(found, "in all pieces", "take longer pieces, more cycles, or denser disks");
    return {};
  }
  double const strain = finished.measured_strain();
  double const found =
      collisions_per_disk(run.scene, finished.mean("Z"), strain, mean_overlap(finished));
  if (!(found < fewest_collisions)) return {};
  return warning_of(found, fmt::format("in the measured strain of {:.3g}", strain),
                    "make the run longer", longer_run(run, 1.5 * fewest_collisions / found));
}

}  // namespace bagnold
