// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <span>

#include "src/run/target_error.hpp"
#include "src/run/warnings/checks.hpp"
#include "src/statistics/steady_start.hpp"

namespace bagnold {

namespace {

constexpr std::size_t fewest_windows = 20;   ///< fewer show no trend
constexpr double least_drift = 0.05;         ///< relative: less matters to few
constexpr double least_without_error = 0.2;  ///< the same where noise is not known

/// Standard errors between the halves; the error of the difference is twice that of the whole. A
/// steady series has more than the first number in 1 of 10^4 cases, if that error is right, and
/// more than the second while MSER-5 cuts off over a quarter in less than 2% (first-order
/// autoregressive noise of 2 to 200 correlation times). A trend over the whole series gives (3
/// blocks)^(1/2) / 2, so at least 2.4.
constexpr double most_if_settled = 4, most_if_not = 2;

double mean(std::span<double const> series) {
  return std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
}

}  // namespace

std::optional<Warning> steady_state(FinishedRun const& finished) {
  for (auto const name : settling_names(finished.run)) {
    auto const* found = finished.of(name);
    if (!found || !found->estimate.all.mean) return {};
    auto const all = window_series(finished.run, found->observable);
    auto const measured =
        std::span(all).subspan(static_cast<std::size_t>(finished.run.plan.discarded_windows));
    if (measured.size() < fewest_windows) return {};
    double const first = mean(measured.first(measured.size() / 2));
    double const second = mean(measured.subspan(measured.size() / 2));
    double const drift = (second - first) / std::abs(*found->estimate.all.mean);
    auto const start = statistics::steady_start(measured);
    bool const settles = start.found && 4 * start.first <= measured.size();
    auto const error = found->estimate.all.rough ? std::nullopt : found->estimate.all.error;
    double const apart = error ? std::abs(second - first) / (2 * *error) : 0.0;
    if (!(std::abs(drift) >= (error ? least_drift : least_without_error))) continue;
    if (settles && !error) continue;
    if (error && !(apart >= (settles ? most_if_settled : most_if_not))) continue;
    return Warning{
        "steady_state",
        {{"drift", drift},
         {"standard_errors", error ? apart : std::nan("")},
         {"transient", static_cast<double>(start.first) / static_cast<double>(measured.size())}},
        fmt::format("{} changes by {:.0f}% from the first to the second half of what is measured{}",
                    name, 100 * drift,
                    settles ? fmt::format(", {:.2g} standard errors", apart)
                            : ", much of which is transient by MSER-5"),
        "make the run longer, or discard more of it",
        longer_run(finished.run, 2)};
  }
  return {};
}

}  // namespace bagnold
