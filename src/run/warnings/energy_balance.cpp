// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_gap = 0.02;

}  // namespace

std::optional<Warning> energy_balance(FinishedRun const& finished) {
  auto const* found = finished.of("energy_gap");
  if (!found || !found->estimate.all.mean || !found->estimate.all.error ||
      found->estimate.all.rough)
    return {};
  double const gap = *found->estimate.all.mean, error = *found->estimate.all.error;
  double const overlap = mean_overlap(finished);
  // Kinetic and elastic energy over L_x L_y: p_kin and, as V_ij ~ overlap f_ij r_ij / alpha, p_el
  // times the overlap at most.
  double const changed = finished.change([&](std::size_t window) {
    return finished.in_window("p_kin", window) +
           (overlap > 0 ? overlap * finished.in_window("p_el", window) : 0.0);
  });
  double const kept = changed / std::abs(finished.mean("sigma") * finished.measured_strain());
  if (std::abs(gap) < most_gap + standard_errors * error + kept) return {};
  return Warning{
      "energy_balance",
      {{"energy_gap", gap}, {"error", error}, {"stored", kept}},
      fmt::format(
          "{:.2g}% of the power of the shear is {}: integration.time_step = {} is too coarse for "
          "these contacts",
          100 * std::abs(gap), gap > 0 ? "not dissipated" : "missing from what is dissipated",
          finished.run.plan.time_step),
      "halve it and compare"};
}

}  // namespace bagnold
