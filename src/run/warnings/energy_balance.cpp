// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_gap = 0.02;

/// Power by which the box that holds a pressure presses on contacts, over that of the shear:
/// motions keep their excess over the mean flow, so its work is -p_el dA. From window to window.
double box_share(FinishedRun const& finished) {
  auto const& run = finished.run;
  if (!run.scene.shear.changes_box()) return 0.0;
  auto const& phi = finished.of("packing_fraction")->observable;
  auto const& pressure = finished.of("p_el")->observable;
  auto const first = static_cast<std::size_t>(run.plan.discarded_windows);
  double work = 0.0;  // of an area of 1
  for (auto const& replica : run.replicas) {
    auto const& windows = replica.measurement.windows;
    auto const value = [&](Observable const& of, std::size_t w) {
      return of.value(windows.mean(w, w + 1));
    };
    for (auto w = first; w + 1 < windows.size(); ++w)
      work += (value(pressure, w) + value(pressure, w + 1)) / 2 *
              std::log(value(phi, w + 1) / value(phi, w));
  }
  return work / static_cast<double>(run.replicas.size()) /
         (finished.mean("sigma") * finished.measured_strain());
}

}  // namespace

double stored_share(FinishedRun const& finished) {
  double const overlap = mean_overlap(finished);
  double const changed = finished.change([&](std::size_t window) {
    return finished.in_window("p_kin", window) +
           (overlap > 0 ? overlap * finished.in_window("p_el", window) : 0.0);
  });
  return changed / std::abs(finished.mean("sigma") * finished.measured_strain());
}

std::string EnergyGap::in_words() const {
  return fmt::format("{:.2g}% of the power of the shear is {}", 100 * std::abs(gap),
                     gap > 0 ? "not dissipated" : "missing from what is dissipated");
}

std::optional<EnergyGap> energy_gap_beyond(double most, FinishedRun const& finished) {
  auto const* named = finished.of("energy_gap");
  if (!named) return {};
  auto const& found = named->estimate.all;
  if (!found.mean || !found.error || found.rough) return {};
  EnergyGap const gap{*found.mean + box_share(finished), *found.error, stored_share(finished)};
  if (!(std::abs(gap.gap) >= most + standard_errors * gap.error + gap.stored)) return {};
  return gap;
}

std::optional<Warning> energy_balance(FinishedRun const& finished) {
  if (ends_quasi_static(finished.run)) return {};  // quasi_static_inertia
  auto const found = energy_gap_beyond(most_gap, finished);
  if (!found) return {};
  return Warning{"energy_balance", found->numbers(),
                 fmt::format("{}: integration.time_step = {} is too coarse for these contacts",
                             found->in_words(), finished.run.plan.time_step),
                 "halve it and compare", half_the_step(finished)};
}

}  // namespace bagnold
