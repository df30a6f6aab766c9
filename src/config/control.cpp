// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"
#include "src/config/scene.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

constexpr double relaxation_strain = 0.5;

/// Share of 1/omega that a piece lasts, omega = sqrt(G/M) that of the box against a packing of a
/// shear modulus G of about k_e/3.
constexpr double piece_of_oscillation = 0.18;

constexpr double most_strain = 1e-3;      ///< of a piece
constexpr std::int64_t fewest_steps = 8;  ///< of a piece at given stress, of a box that bears it

/// Largest share of (M/k_e)^(1/2) that a piece may last: of a packing with G = k_e/3 the stress at
/// the end of a piece, extrapolated from the last two, makes the box swing more and more from about
/// (omega T)^2 = 0.1 on, where contacts do not damp it.
constexpr double most_of_oscillation = 0.5;
constexpr std::int64_t fewest_builds = 50;  ///< of a piece at given pressure, which renews lists

std::int64_t control_steps(Scene const& scene) {
  double const strain_steps = most_strain / (scene.shear.strain_rate * time_step(scene));
  if (scene.shear.changes_box())
    return std::max(fewest_builds, static_cast<std::int64_t>(std::min(strain_steps, most_steps)));
  double const root = std::sqrt(box_inertia(scene)) / time_step(scene);
  auto const fewest =
      std::clamp(static_cast<std::int64_t>(std::min(most_of_oscillation * root, most_steps)),
                 std::int64_t{1}, fewest_steps);
  return std::max(fewest, static_cast<std::int64_t>(
                              std::min({piece_of_oscillation * root, strain_steps, most_steps})));
}

}  // namespace

double least_box_inertia(Scene const& scene) {
  return std::pow(time_step(scene) / most_of_oscillation, 2);
}

double box_inertia(Scene const& scene) {
  auto const& shear = scene.shear;
  return shear.box_inertia.value_or(relaxation_strain * shear.stress /
                                    (shear.strain_rate * shear.strain_rate));
}

Plan plan_of_control(Scene const& scene) {
  auto const& shear = scene.shear;
  bool const of_stress = shear.finds_rate();
  Plan plan;
  plan.strain_rate = shear.strain_rate;
  plan.time_step = time_step(scene);
  plan.every = scene.measure.every;
  plan.control_steps = control_steps(scene);
  double const step_strain = plan.time_step * shear.strain_rate;
  auto const piece = static_cast<double>(plan.control_steps);
  double const window = std::max(1.0, round_up(scene.output.sample_strain / step_strain / piece));
  double const each =
      of_stress ? shear.time / plan.time_step : static_cast<double>(shear.strain) / step_strain;
  double const stages = of_stress ? static_cast<double>(shear.stress.each.size()) : 1;
  double const windows = stages * std::max(1.0, round_up(each / (window * piece)));
  double const steps = windows * window * piece;
  if (!(steps * static_cast<double>(scene.disks.replicas) <= most_steps))
    throw InputError(fmt::format("{} takes {:.3g} steps (limit {:.0g}); lower it",
                                 of_stress ? fmt::format("shear.time = {}", shear.time)
                                           : fmt::format("shear.strain = {}", shear.strain.at(0)),
                                 steps, most_steps));
  plan.window_steps = static_cast<std::int64_t>(window * piece);
  plan.windows = static_cast<std::int64_t>(windows);
  plan.steps = plan.windows * plan.window_steps;
  plan.stages = static_cast<std::int64_t>(stages);
  plan.by_time = of_stress;
  double const frames = of_stress ? scene.output.trajectory_time / plan.time_step
                                  : scene.output.trajectory_strain / step_strain;
  if (frames > 0)
    plan.trajectory_steps =
        static_cast<std::int64_t>(std::clamp(round_up(frames), 1.0, most_steps));
  return plan;
}

}  // namespace bagnold
