// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/passes.hpp"

#include <cmath>

#include "src/statistics/jackknife.hpp"

namespace bagnold {

void Passes::add(std::pair<std::size_t, std::int64_t> pass, std::span<double const> sums,
                 double weight) {
  WindowSums& to = of[pass];
  to.sums.resize(sums.size());
  for (std::size_t c = 0; c < sums.size(); ++c) to.sums[c] += sums[c];
  to.weight += weight;
  ++windows;
}

std::pair<std::size_t, std::int64_t> pass_of(Run const& run, std::size_t replica,
                                             std::int64_t cycle) {
  return {replica, run.replicas.size() >= statistics::fewest_replicas ? 0 : cycle};
}

statistics::Windows Passes::table() const {
  statistics::Windows table{of.empty() ? 0 : of.begin()->second.sums.size(), {}, {}};
  for (auto const& [pass, window] : of) table.push_back(window.sums, window.weight);
  return table;
}

statistics::Estimate estimate_of_passes(statistics::Windows const& passes,
                                        statistics::Function const& f) {
  statistics::Estimate estimate;
  estimate.samples = passes.size();
  statistics::Jackknife jackknife(passes, 0, f);
  if (!std::isfinite(jackknife.value())) return estimate;
  estimate.mean = jackknife.value();
  if (passes.size() < statistics::fewest_replicas) return estimate;
  if (double const error = jackknife.error(1); std::isfinite(error)) estimate.error = error;
  return estimate;
}

}  // namespace bagnold
