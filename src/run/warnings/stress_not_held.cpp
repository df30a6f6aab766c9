// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/run/protocols/stress/stress_results.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

/// Of the stresses of a list, the one that is furthest from being held.
std::optional<Warning> stress_not_held(FinishedRun const& finished) {
  double furthest = 0;
  std::optional<Warning> warning;
  for (auto const& [stress, strain, windows, observables, estimates] :
       stress_results(finished.run)) {
    auto const at = std::ranges::find(observables, "sigma", &Observable::name);
    auto const& sigma = estimates[static_cast<std::size_t>(at - observables.begin())];
    if (!sigma.mean || is_held(sigma, stress)) continue;
    double const off = std::abs(*sigma.mean - stress);
    if (off / stress <= furthest) continue;
    furthest = off / stress;
    warning = {"stress_not_held",
               {{"stress", stress}, {"sigma", *sigma.mean}, {"error", sigma.error.value_or(0)}},
               fmt::format("sigma is {:.3g} m/tau_e^2 where {:.3g} is to be held: the box still "
                           "changes its speed",
                           *sigma.mean, stress),
               "a longer shear.time, a smaller shear.box_inertia, or a shear.strain_rate nearer to "
               "that of the flow",
               longer_run(finished.run, 4)};
  }
  return warning;
}

}  // namespace bagnold
