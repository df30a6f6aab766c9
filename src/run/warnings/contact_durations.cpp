// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// Share of the run's time above which tau_dur lacks longer contacts.
constexpr double longest_share = 0.1;

/// Largest share of Z of contacts that have begun and not ended: without them Z = 2 tau_dur
/// nu_coll.
constexpr double largest_gap = 0.1;

}  // namespace

std::optional<Warning> contact_durations(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  if (!scene.measure.contacts || finished.found.empty()) return {};
  double const contacts = finished.mean("Z"), duration = finished.mean("tau_dur");
  if (!(contacts > 0)) return {};
  auto const& plan = finished.run.plan;
  double const time = plan.time_step * static_cast<double>(plan.steps);
  double const share = duration / time;  // NaN where no contact ended
  double const gap = 1 - 2 * duration * finished.mean("nu_coll") / contacts;
  if (share < longest_share && std::abs(gap) < largest_gap) return {};
  auto const reason =
      std::isnan(duration)
          ? fmt::format("no contact that began in the run ended in what is measured, of Z = {:.3g}",
                        contacts)
          : fmt::format(
                "tau_dur = {:.3g} in a run of {:.3g} tau_e, and 2 tau_dur nu_coll is {:.2g} "
                "times Z: contacts that last longer are missing",
                duration, time, 1 - gap);
  return Warning{"contact_durations",
                 {{"tau_dur", duration}, {"time", time}, {"gap", gap}},
                 reason,
                 "make the run longer",
                 longer_run(finished.run, std::isnan(share) ? 10 : 2 * share / longest_share)};
}

}  // namespace bagnold
