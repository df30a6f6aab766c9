// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "src/analysis/paper_values.hpp"
#include "src/cli/run_results.hpp"

namespace bagnold {

namespace {

std::string with_error(statistics::Estimate const& estimate) {
  if (!estimate.mean) return "undefined";
  if (!estimate.error) return fmt::format("{:.4g} (no error)", *estimate.mean);
  return fmt::format("{:.4g} +- {:.1g}", *estimate.mean, *estimate.error);
}

}  // namespace

void print_table(Run const& run, std::vector<NamedEstimate> const& list) {
  double const window_strain =
      run.plan.time_step * run.scene.shear.strain_rate * static_cast<double>(run.plan.window_steps);
  fmt::print("\n{:<13} {:<26} {:<17} {:<19} {}\n", "quantity", "mean +- standard error", "unit",
             "correlation strain", "what it is");
  for (auto const& [observable, estimate] : list)
    fmt::print("{:<13} {:<26} {:<17} {:<19} {}\n", observable.name, with_error(estimate.all),
               observable.unit,
               estimate.all.correlation
                   ? fmt::format("{:.2g}", *estimate.all.correlation * window_strain)
                   : "-",
               observable.meaning);

  if (run.replicas.size() > 1)
    fmt::print("\n{} replicas, seeds {} to {}; errors: {}\n", run.replicas.size(),
               run.scene.disks.seed,
               run.scene.disks.seed + static_cast<std::int64_t>(run.replicas.size()) - 1,
               statistics::error_source(run.replicas.size()));

  std::set<std::string> remarks;
  for (auto const& named : list)
    if (auto const& all = named.estimate.all; !all.remark.empty() && !all.error)
      remarks.insert(all.remark);
  if (!remarks.empty())
    fmt::print("\nno error where the statistics are too short: {}\n", *remarks.begin());

  std::vector<Observable> only;
  for (auto const& named : list) only.push_back(named.observable);
  auto const papers = paper_values(run.scene, only);
  if (papers.empty()) return;
  fmt::print("\n{:<18} {:<26} {:<28} {}\n", "quantity", "ours", "the paper", "where");
  for (auto const& paper : papers)
    fmt::print("{:<18} {:<26} {:<28} {}\n", paper.quantity,
               with_error(estimate(run, paper.value).all), paper.stated, paper.source);
}

}  // namespace bagnold
