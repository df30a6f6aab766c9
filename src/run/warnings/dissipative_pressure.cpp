// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double small_share = 0.05;

}  // namespace

std::optional<Warning> dissipative_pressure(FinishedRun const& finished) {
  if (ends_quasi_static(finished.run)) return {};  // quasi_static_inertia
  auto const* found = finished.of("p_dis_share");
  if (!found || !found->estimate.all.mean || !found->estimate.all.error) return {};
  double const share = *found->estimate.all.mean, error = *found->estimate.all.error;
  if (!(std::abs(share) >= small_share + standard_errors * error)) return {};
  return Warning{
      "dissipative_pressure",
      {{"p_dis_share", share}, {"error", error}},
      fmt::format("p_dis is {:.2g}% of p, of whole contacts none: integration.time_step = {} is "
                  "too coarse for these contacts",
                  100 * share, finished.run.plan.time_step),
      "halve it and compare",
      half_the_step(finished)};
}

}  // namespace bagnold
