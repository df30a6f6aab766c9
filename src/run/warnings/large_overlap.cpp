// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/collisions.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_overlap = 0.02;

/// What decides on the overlap, and the command that lowers it; "" where a command would need more
/// than one key.
Warning with_remedy(Warning warning, Scene const& scene) {
  auto const& shear = scene.shear;
  auto const tenth = [](double value) { return fmt::format("{:.3g}", value / 10); };
  if (shear.changes_box()) {
    warning.remedy = "lower shear.pressure";
    if (!shear.inertial_number)
      warning.command = changed_run("shear.pressure", tenth(shear.pressure));
  } else if (shear.finds_rate()) {
    warning.remedy = "lower shear.stress";
    warning.command = changed_run("shear.stress", tenth(shear.stress));
  } else {
    warning.remedy = "lower shear.strain_rate or disks.packing_fraction";
    warning.command = changed_run("shear.strain_rate", tenth(shear.strain_rate));
  }
  return warning;
}

}  // namespace

double mean_overlap(FinishedRun const& finished) {
  return mean_overlap(finished.run.scene, finished.mean("p_el"), finished.mean("Z"),
                      finished.box_area());
}

std::optional<Warning> large_overlap(FinishedRun const& finished) {
  double const overlap = mean_overlap(finished);
  if (!(overlap > most_overlap)) return {};
  return with_remedy(
      {"large_overlap",
       {{"mean_overlap", overlap}},
       fmt::format("disks in contact overlap by {:.2g}% on average: soft bodies, not grains",
                   100 * overlap),
       "",
       "",
       /*is_note=*/true},
      finished.run.scene);
}

}  // namespace bagnold
