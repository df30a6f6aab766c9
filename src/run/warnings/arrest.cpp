// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double least_strain = 0.05;  ///< a packing that yields strains by as much and more

}  // namespace

/// Over the second half of the time at each stress; told of the largest at which a replica stops.
std::optional<Warning> arrest(FinishedRun const& finished) {
  if (stress_not_held(finished)) return {};  // it may flow yet
  auto const& run = finished.run;
  auto const of_stage = static_cast<std::size_t>(run.plan.windows / run.plan.stages);
  auto const half = of_stage / 2;
  if (half == 0) return {};
  double const time =
      run.plan.time_step * static_cast<double>(half) * static_cast<double>(run.plan.window_steps);
  std::vector<std::vector<double>> all;
  for (auto const& replica : run.replicas) all.push_back(strains_of(run, replica));
  std::optional<Warning> warning;
  double largest = 0;
  for (std::size_t stage = 0; stage < static_cast<std::size_t>(run.plan.stages); ++stage) {
    double const stress = run.scene.shear.stress.at(stage);
    auto const end = (stage + 1) * of_stage - 1;
    double most = 0;  // strain of those that stop
    std::size_t stopped = 0;
    for (auto const& strains : all) {
      double const strain = std::abs(strains[end] - strains[end - half]);
      if (strain >= least_strain) continue;
      most = std::max(most, strain);
      ++stopped;
    }
    if (stopped == 0 || stress <= largest) continue;
    largest = stress;
    auto const who = stopped == run.replicas.size()
                         ? std::string("it flows")
                         : fmt::format("{} of {} replicas flow", stopped, run.replicas.size());
    warning = {
        "arrest",
        {{"strain", most}, {"time", time}, {"strain_rate", most / time}},
        fmt::format("at the stress {:.4g} m/tau_e^2 {} at less than {:.2g}/tau_e for {:.3g} tau_e, "
                    "a strain of {:.2g}: stopped, or creeping",
                    stress, who, most / time, time, most),
        "averages are of packings at rest; take a larger shear.stress for a flow, a longer "
        "shear.time for creep",
        {},
        /*is_note=*/true};
  }
  return warning;
}

}  // namespace bagnold
