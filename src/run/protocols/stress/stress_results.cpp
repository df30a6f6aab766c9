// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/stress/stress_results.hpp"

#include <algorithm>

#include "src/engine/control_columns.hpp"

namespace bagnold {

std::vector<StressResult> stress_results(Run const& run) {
  auto const list = observables(run.scene, run.box_length);
  auto const of_stage = static_cast<std::size_t>(run.plan.windows / run.plan.stages);
  auto const left_out = static_cast<std::size_t>(run.plan.discarded_windows);
  double const window_time = run.plan.time_step * static_cast<double>(run.plan.window_steps);
  std::vector<StressResult> results;
  for (std::size_t k = 0; k < static_cast<std::size_t>(run.plan.stages); ++k) {
    std::vector<statistics::Windows> measured;
    for (auto const& replica : run.replicas) {
      auto const& all = replica.measurement.windows;
      statistics::Windows part{all.columns, {}, {}};
      for (auto w = k * of_stage + left_out; w < std::min((k + 1) * of_stage, all.size()); ++w)
        part.push_back(all.row(w), all.weight[w]);
      measured.push_back(std::move(part));
    }
    StressResult result;
    result.stress = run.scene.shear.stress.at(k);
    result.windows = measured.front().size();
    std::vector<statistics::Windows const*> tables;
    for (auto const& one : measured) {
      tables.push_back(&one);
      auto const rate = one.columns - ControlColumns::count + ControlColumns::strain_rate;
      if (one.size() > 0)
        result.strain += one.mean(0, one.size())[rate] * window_time *
                         static_cast<double>(one.size()) / static_cast<double>(measured.size());
    }
    result.observables = list;
    for (auto const& observable : list)
      result.estimates.push_back(statistics::estimate(tables, 0, observable.value).all);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace bagnold
