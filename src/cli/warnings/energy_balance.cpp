// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/cli/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_gap = 0.02;
constexpr double standard_errors = 4;

/// Kinetic and elastic energy over L^2 in a window, [m / tau_e^2]: p_kin and, as V_ij ~ overlap
/// f_ij r_ij / alpha, p_el times the overlap at most.
double energy(Finished const& finished, double overlap, std::size_t window) {
  auto const at = [&](char const* name) {
    double sum = 0;
    for (auto const& replica : finished.run.replicas)
      sum +=
          finished.of(name)->observable.value(replica.measurement.windows.mean(window, window + 1));
    return sum / static_cast<double>(finished.run.replicas.size());
  };
  return at("p_kin") + (overlap > 0 ? overlap * at("p_el") : 0.0);
}

}  // namespace

std::optional<Warning> energy_balance(Finished const& finished) {
  auto const* found = finished.of("energy_gap");
  if (!found || !found->estimate.all.mean || !found->estimate.all.error ||
      found->estimate.all.rough)
    return {};
  double const gap = *found->estimate.all.mean, error = *found->estimate.all.error;
  auto const first = static_cast<std::size_t>(finished.run.plan.discarded_windows);
  auto const last = static_cast<std::size_t>(finished.run.plan.windows) - 1;
  double const overlap = mean_overlap(finished);
  double const kept = std::abs(energy(finished, overlap, last) - energy(finished, overlap, first)) /
                      std::abs(finished.mean("sigma") * finished.measured_strain());
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
