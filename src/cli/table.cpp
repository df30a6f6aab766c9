// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/run/paper_values.hpp"
#include "src/run/protocols/ramp/hysteresis.hpp"

namespace bagnold {

namespace {

std::string with_error(statistics::Estimate const& estimate) {
  if (!estimate.mean) return "undefined";
  if (!estimate.error) return fmt::format("{:.4g} (no error)", *estimate.mean);
  return fmt::format("{:.4g} +- {:.1g}{}", *estimate.mean, *estimate.error,
                     estimate.rough ? " (rough)" : "");
}

/// Shear stress up and down, every few rates.
void print_loop(Run const& run) {
  Loop const loop = loop_of(run);
  auto const sigma = [](LoopBin const& bin) {
    auto const at = std::ranges::find(bin.observables, "sigma", &Observable::name);
    return with_error(bin.estimates[static_cast<std::size_t>(at - bin.observables.begin())]);
  };
  fmt::print("\n{:<13} {:<28} {}\n", "strain rate", "sigma up [m/tau_e^2]", "sigma down");
  for (std::size_t k = 0; k < std::min(loop.up.size(), loop.down.size());
       k += loop_bins_a_decade / 4)
    fmt::print("{:<13.3g} {:<28} {}\n", loop.up[k].strain_rate, sigma(loop.up[k]),
               sigma(loop.down[k]));
}

/// Where a run that looks at errors ended, and what "auto" discarded.
void print_ends(Run const& run) {
  if (!run.scene.shear.discard)
    fmt::print("\nsteady {} (MSER-5): {} of {} windows discarded\n",
               run.steady_found ? "state found" : "state not found, so half discarded: run longer",
               run.plan.discarded_windows, run.plan.windows);
  for (auto const& [name, error] : run.reached)
    fmt::print("relative error of {}: {} wanted, {} reached at strain {:.4g}\n", name,
               run.scene.shear.target_error.at(name),
               error ? fmt::format("{:.2g}", *error) : "none", run.plan.strain(run.plan.steps));
  if (!run.reached.empty() && !run.target_met)
    fmt::print("not reached at two looks in a row: raise shear.strain\n");
}

}  // namespace

void print_table(Run const& run, std::vector<NamedEstimate> const& list) {
  if (run.plan.ramp) return print_loop(run);
  fmt::print("\n{:<13} {:<26} {:<17} {:<19} {}\n", "quantity", "mean +- standard error", "unit",
             "correlation strain", "what it is");
  for (auto const& named : list) {
    auto const& [name, unit, meaning, value] = named.observable;
    auto const& all = named.estimate.all;
    fmt::print(
        "{:<13} {:<26} {:<17} {:<19} {}\n", name, with_error(all), unit,
        all.correlation ? fmt::format("{:.2g}", *all.correlation * named.sample_strain) : "-",
        meaning);
  }

  print_ends(run);
  if (run.replicas.size() > 1)
    fmt::print("\n{} replicas, seeds {} to {}; errors: {}\n", run.replicas.size(),
               run.scene.disks.seed,
               run.scene.disks.seed + static_cast<std::int64_t>(run.replicas.size()) - 1,
               errors_from(run));

  std::set<std::string> remarks, rough;
  for (auto const& named : list)
    if (auto const& all = named.estimate.all; !all.remark.empty())
      (all.error ? rough : remarks).insert(all.remark);
  if (!remarks.empty())
    fmt::print("\nno error where the statistics are too short: {}\n", *remarks.begin());
  if (!rough.empty())
    fmt::print("\nrough: errors from few blocks, with Student's factor: {}\n", *rough.begin());

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
