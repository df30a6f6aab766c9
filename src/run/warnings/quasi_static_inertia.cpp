// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/quasi_static.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_gap_of_creep = 0.01;  ///< docs/accuracy.md, "Quasi-static steps"

}  // namespace

bool ends_quasi_static(Run const& run) {
  return is_quasi_static(run.scene) || (run.bias && is_quasi_static(run.bias->methods.coarse));
}

std::optional<Warning> quasi_static_inertia(FinishedRun const& finished) {
  if (!ends_quasi_static(finished.run)) return {};
  auto const found = energy_gap_beyond(most_gap_of_creep, finished);
  if (!found) return {};
  return Warning{
      "quasi_static_inertia", found->numbers(),
      fmt::format("{}: inertia has a part in this flow, and integration.engine = \"{}\" may hold "
                  "it in another state than it would be in",
                  found->in_words(), quasi_static_engine),
      is_quasi_static(finished.run.scene)
          ? "set integration.engine = \"auto\", which steps through collisions"
          : "set integration.scheme = \"two-stage-leapfrog\", which steps through collisions",
      "bagnold run DIR/scene.toml --set integration.engine=auto --set "
      "integration.scheme=two-stage-leapfrog --set integration.time_step=auto --out "
      "DIR-two-stages"};
}

}  // namespace bagnold
