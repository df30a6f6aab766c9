// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "kernels/physics/species.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_power = 0.01;

/// Rotational energy per area of the box in a window, if all disks were big, [m / tau_e^2].
double energy(FinishedRun const& finished, std::size_t window) {
  auto const& [run, found] = finished;
  double const rate = run.scene.shear.strain_rate;
  double const mean = finished.in_window("spin_mean", window);
  double const spin2 = (finished.in_window("spin_var", window) + mean * mean) * rate * rate;
  double const inertia =
      disk_mass(run.scene.mass_by_area(), big_diameter) * big_diameter * big_diameter / 8;
  double const density = static_cast<double>(run.scene.disks.count) / finished.box_area();
  return density * inertia * spin2 / 2;
}

}  // namespace

std::optional<Warning> rotation_balance(FinishedRun const& finished) {
  auto const* found = finished.of("torque_power");
  if (!found || !found->estimate.all.mean || !found->estimate.all.error) return {};
  if (finished.run.scene.driven()) return {};      // a fluid takes torques too
  if (ends_quasi_static(finished.run)) return {};  // quasi_static_inertia
  double const power = *found->estimate.all.mean, error = *found->estimate.all.error;
  double const changed = finished.change([&](std::size_t w) { return energy(finished, w); });
  double const kept = changed / std::abs(finished.mean("sigma") * finished.measured_strain());
  if (!(std::abs(power) >= most_power + standard_errors * error + kept)) return {};
  return Warning{
      "rotation_balance",
      {{"torque_power", power}, {"error", error}, {"stored", kept}},
      fmt::format("torques {} the rotation {:.2g}% of the power of the shear, which it does not "
                  "{}: integration.time_step = {} is too coarse for these contacts",
                  power > 0 ? "give" : "take from", 100 * std::abs(power),
                  power > 0 ? "keep" : "have", finished.run.plan.time_step),
      "halve it and compare",
      half_the_step(finished)};
}

}  // namespace bagnold
