// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep_times.hpp"

namespace bagnold::sweep {

RunTimes times_of_points(Sweep const& sweep) {
  std::vector<PlannedRun> runs;
  for (auto const& point : sweep.points) runs.push_back({point.scene, point.plan});
  return times_of_many(runs);
}

RunTime longest_chain(Sweep const& sweep, RunTimes const& times) {
  RunTime longest;
  for (auto const& chain : sweep.chains) {
    RunTime time;
    for (auto const k : chain) time += times.each[k];
    if (time.expected > longest.expected) longest = time;
  }
  return longest;
}

double disk_steps(Sweep const& sweep) {
  double steps = 0;
  for (auto const& point : sweep.points) steps += bagnold::disk_steps(point.scene, point.plan);
  return steps;
}

}  // namespace bagnold::sweep
