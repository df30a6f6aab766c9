// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

NamedEstimate const* FinishedRun::of(std::string_view name) const {
  auto const at =
      std::ranges::find(found, name, [](NamedEstimate const& one) { return one.observable.name; });
  return at == found.end() ? nullptr : &*at;
}

double FinishedRun::mean(std::string_view name) const {
  auto const* estimate = of(name);
  return estimate && estimate->estimate.all.mean ? *estimate->estimate.all.mean
                                                 : std::numeric_limits<double>::quiet_NaN();
}

double FinishedRun::measured_strain() const {
  auto const& plan = run.plan;
  double const first =
      plan.discarded_windows == 0 ? 0.0 : plan.strain(plan.window_end(plan.discarded_windows - 1));
  return plan.strain(plan.steps) - first;
}

double FinishedRun::in_window(std::string_view name, std::size_t window) const {
  auto const& [observable, samples] = static_cast<SampledObservable const&>(*of(name));
  double sum = 0;
  for (auto const* of_replica : samples)
    sum += observable.value(of_replica->mean(window, window + 1));
  return sum / static_cast<double>(samples.size());
}

std::vector<Warning> warnings(FinishedRun const& finished) {
  std::vector<Warning> list;
  for (auto* check : all_checks)
    if (auto warning = check(finished)) list.push_back(std::move(*warning));
  return list;
}

std::string text_of(Warning const& warning) {
  return fmt::format("{}: {}; {}", warning.name, warning.reason, warning.remedy);
}

}  // namespace bagnold
