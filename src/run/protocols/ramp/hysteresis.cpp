// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/ramp/hysteresis.hpp"

#include <cmath>
#include <map>

#include "src/run/protocols/passes.hpp"

namespace bagnold {

namespace {

/// Windows of one direction, one bin.
struct Bin {
  Passes passes;
  double rates = 0;  ///< sum over windows
};

LoopBin bin_of(Run const& run, Bin const& of) {
  LoopBin bin;
  bin.windows = of.passes.windows;
  bin.strain_rate = of.rates / static_cast<double>(of.passes.windows);
  auto const table = of.passes.table();
  Scene scene = run.scene;
  scene.shear.strain_rate = bin.strain_rate;
  bin.observables = observables(scene, run.box_length);
  for (auto const& observable : bin.observables)
    bin.estimates.push_back(estimate_of_passes(table, observable.value));
  return bin;
}

}  // namespace

Loop loop_of(Run const& run) {
  std::map<int, std::map<int, Bin>> bins;  // by direction, then place
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
      Bin& bin = bins[plan.direction(window)][place];
      bin.passes.add({r, leg}, windows.row(w), windows.weight[w]);
      bin.rates += rate;
    }
  }
  Loop loop;
  for (auto const& [place, bin] : bins[+1]) loop.up.push_back(bin_of(run, bin));
  for (auto const& [place, bin] : bins[-1]) loop.down.push_back(bin_of(run, bin));
  return loop;
}

}  // namespace bagnold
