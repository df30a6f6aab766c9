// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// Ratio of the scatter of replicas to that expected from their own errors, above which they are
/// not of one state: four standard deviations for two of them, and rarer for more.
constexpr double most_scatter = 4;

/// (1/(R - 1)) sum (x_r - mean)^2 over the mean of the squared errors of each, its root; 0 where
/// replicas have none of their own, or rough ones.
double scatter_over_errors(statistics::ReplicaEstimate const& found) {
  double sum = 0, squares = 0, errors = 0;
  auto const count = static_cast<double>(found.each.size());
  for (auto const& one : found.each) {
    if (!one.mean || !one.error || one.rough || *one.error == 0) return 0;
    sum += *one.mean;
    squares += *one.mean * *one.mean;
    errors += *one.error * *one.error;
  }
  return count < 2 ? 0 : std::sqrt((squares - sum * sum / count) / (count - 1) / (errors / count));
}

Warning none_or_rough(FinishedRun const& finished, NamedEstimate const& found) {
  auto const& all = found.estimate.all;
  double const strain = finished.measured_strain();
  double const replicas = static_cast<double>(finished.run.replicas.size());
  double const correlation = strain * replicas / (2 * all.independent);
  return {
      "error_bar",
      {{"measured_strain", strain},
       {"correlation_strain", all.independent > 0 ? correlation : std::nan("")},
       {"independent_windows", all.independent}},
      all.rough
          ? fmt::format("{} has a rough error, from {} blocks of the measured strain of {:.3g}: a "
                        "sure one takes {}",
                        found.observable.name, all.blocks, strain, statistics::fewest_blocks)
          : fmt::format("{} has no error: the measured strain of {:.3g} holds about {:.2g} "
                        "independent windows, an error takes {}",
                        found.observable.name, strain, all.independent, enough_windows),
      "make the run longer, or take disks.replicas of 3 or more",
      until_errors(finished),
      /*is_note=*/all.rough};
}

}  // namespace

std::optional<Warning> error_bar(FinishedRun const& finished) {
  for (auto const* name : {"B_p", "B_sigma"}) {
    auto const* found = finished.of(name);
    if (!found) return {};
    if (auto const& all = found->estimate.all; !all.error || all.rough)
      return none_or_rough(finished, *found);
    if (double const scatter = scatter_over_errors(found->estimate); scatter > most_scatter)
      return Warning{
          "error_bar",
          {{"scatter_over_errors", scatter}},
          fmt::format("replicas differ in {} by {:.2g} times what the fluctuations of each "
                      "explain: they sit in different states",
                      name, scatter),
          "make the run longer, and look at the replicas one by one",
          longer_run(finished.run, 3)};
  }
  return {};
}

}  // namespace bagnold
