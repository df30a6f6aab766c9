// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_overlap = 0.02;

}  // namespace

double mean_overlap(FinishedRun const& finished) {
  auto const& disks = finished.run.scene.disks;
  double const area = finished.run.box_area();
  double const contacts = static_cast<double>(disks.count) * finished.mean("Z") / 2;
  return std::pow(2 * finished.mean("p_el") * area / contacts, 1 / (disks.force_exponent - 1));
}

std::optional<Warning> large_overlap(FinishedRun const& finished) {
  double const overlap = mean_overlap(finished);
  if (!(overlap > most_overlap)) return {};
  return Warning{
      "large_overlap",
      {{"mean_overlap", overlap}},
      fmt::format("disks in contact overlap by {:.2g}% on average: soft bodies, not grains",
                  100 * overlap),
      "lower shear.strain_rate or disks.packing_fraction",
      changed_run("shear.strain_rate",
                  fmt::format("{:.3g}", finished.run.scene.shear.strain_rate / 10)),
      /*is_note=*/true};
}

}  // namespace bagnold
