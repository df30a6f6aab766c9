// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double least_strain = 0.05;  ///< a packing that yields strains by as much and more

}  // namespace

/// Over the second half of the time at the last stress.
std::optional<Warning> arrest(FinishedRun const& finished) {
  if (stress_not_held(finished)) return {};  // it may flow yet
  auto const& run = finished.run;
  auto const windows = static_cast<std::size_t>(run.plan.windows);
  auto const half = static_cast<std::size_t>(run.plan.windows / run.plan.stages) / 2;
  if (half == 0) return {};
  double strain = 0;
  for (auto const& replica : run.replicas) {
    auto const strains = strains_of(run, replica);
    strain = std::max(strain, std::abs(strains[windows - 1] - strains[windows - 1 - half]));
  }
  if (strain >= least_strain) return {};
  double const time =
      run.plan.time_step * static_cast<double>(half) * static_cast<double>(run.plan.window_steps);
  double const stress = run.scene.shear.stress.each.back();
  return Warning{
      "arrest",
      {{"strain", strain}, {"time", time}, {"strain_rate", strain / time}},
      fmt::format("at the stress {:.4g} m/tau_e^2 it flows at less than {:.2g}/tau_e for "
                  "{:.3g} tau_e, a strain of {:.2g}: it has stopped or creeps",
                  stress, strain / time, time, strain),
      "averages are of a packing at rest; take a larger shear.stress for a flow, a longer "
      "shear.time for creep",
      {},
      /*is_note=*/true};
}

}  // namespace bagnold
