// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// Drift of a cycle over gamma_0 (G'^2 + G''^2)^(1/2). A drift that is linear is fitted; its
/// curvature is left in G''.
constexpr double most_drift = 0.1;

}  // namespace

std::optional<Warning> stress_drift(FinishedRun const& finished) {
  auto const* found = finished.of("sigma_drift");
  if (!found) return {};
  double square = 0;  // replicas relax to either side
  for (auto const& one : found->estimate.each)
    square += one.mean ? *one.mean * *one.mean : std::nan("");
  double const drift = std::sqrt(square / static_cast<double>(found->estimate.each.size()));
  double const answer = finished.run.scene.shear.amplitude *
                        std::hypot(finished.mean("G_storage"), finished.mean("G_loss"));
  if (!(drift > most_drift * answer)) return {};
  return Warning{
      "stress_drift",
      {{"sigma_drift", drift}, {"share", drift / answer}},
      fmt::format("sigma changes by {:.2g} m/tau_e^2 from cycle to cycle, {:.2g} of what "
                  "shear.amplitude = {} does: the packing still relaxes, and G'' may be off",
                  drift, drift / answer, finished.run.scene.shear.amplitude),
      "let it come to rest first, by a longer stop (shear.protocol = \"sequence\"), or take a "
      "larger "
      "amplitude or more cycles"};
}

}  // namespace bagnold
