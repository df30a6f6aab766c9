// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/ramp/hysteresis.hpp"

#include <cmath>
#include <map>

#include "src/statistics/jackknife.hpp"

namespace bagnold {

namespace {

/// Windows of one direction, one bin.
struct Passes {
  double rates = 0;  ///< sum over windows
  std::size_t windows = 0;
  std::map<std::pair<std::size_t, std::int64_t>, WindowSums> of;  ///< by replica and leg

  void add(std::pair<std::size_t, std::int64_t> pass, std::span<double const> sums, double weight,
           double rate) {
    WindowSums& to = of[pass];
    to.sums.resize(sums.size());
    for (std::size_t c = 0; c < sums.size(); ++c) to.sums[c] += sums[c];
    to.weight += weight;
    rates += rate;
    ++windows;
  }
};

statistics::Estimate estimate_of(statistics::Windows const& passes, statistics::Function const& f) {
  statistics::Estimate estimate;
  estimate.samples = passes.size();
  statistics::Jackknife jackknife(passes, 0, f);
  if (!std::isfinite(jackknife.value())) return estimate;
  estimate.mean = jackknife.value();
  if (passes.size() < statistics::fewest_replicas) return estimate;
  if (double const error = jackknife.error(1); std::isfinite(error)) estimate.error = error;
  return estimate;
}

LoopBin bin_of(Run const& run, Passes const& passes) {
  LoopBin bin;
  bin.windows = passes.windows;
  bin.strain_rate = passes.rates / static_cast<double>(passes.windows);
  statistics::Windows table{passes.of.begin()->second.sums.size(), {}, {}};
  for (auto const& [pass, window] : passes.of) table.push_back(window.sums, window.weight);
  Scene scene = run.scene;
  scene.shear.strain_rate = bin.strain_rate;
  bin.observables = observables(scene, run.box_length);
  for (auto const& observable : bin.observables)
    bin.estimates.push_back(estimate_of(table, observable.value));
  return bin;
}

}  // namespace

Loop loop_of(Run const& run) {
  std::map<int, std::map<int, Passes>> bins;  // by direction, then place
  auto const& plan = run.plan;
  for (std::size_t r = 0; r < run.replicas.size(); ++r) {
    auto const& windows = run.replicas[r].measurement.windows;
    for (auto w = static_cast<std::size_t>(plan.discarded_windows); w < windows.size(); ++w) {
      auto const window = static_cast<std::int64_t>(w);
      auto const leg =
          (window * plan.window_steps - plan.ramp->first_leg()) / plan.ramp->leg_steps();
      double const rate = plan.mean_rate(window);
      int const place =
          static_cast<int>(std::floor(loop_bins_a_decade * std::log10(rate / plan.ramp->lowest)));
      bins[plan.direction(window)][place].add({r, leg}, windows.row(w), windows.weight[w], rate);
    }
  }
  Loop loop;
  for (auto const& [place, passes] : bins[+1]) loop.up.push_back(bin_of(run, passes));
  for (auto const& [place, passes] : bins[-1]) loop.down.push_back(bin_of(run, passes));
  return loop;
}

}  // namespace bagnold
