// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "src/cli/checked_sweep.hpp"
#include "src/cli/commands.hpp"
#include "src/config/errors.hpp"
#include "src/config/run_time.hpp"

namespace bagnold {

int validate_sweep_command(RunOptions const& options) {
  if (!options.overrides.empty())
    throw InputError(fmt::format("--set {}: does not go with a sweep; change {}",
                                 options.overrides.front(), options.scene_file.string()));
  auto const sweep = read_checked_sweep(options.scene_file, options.allow_unstable);
  double disk_steps = 0;
  RunTime all, longest;
  for (auto const& chain : sweep.chains) {
    RunTime time;
    for (auto const k : chain) {
      auto const& [scene, plan] = std::tie(sweep.points[k].scene, sweep.points[k].plan);
      RunTime const one = estimated_time(scene, plan);
      time = {time.least + one.least, time.most + one.most};
      disk_steps += static_cast<double>(plan.steps) * static_cast<double>(scene.disks.count);
    }
    all = {all.least + time.least, all.most + time.most};
    longest = {std::max(longest.least, time.least), std::max(longest.most, time.most)};
  }
  for (std::size_t k = 0; k < sweep.points.size(); ++k) fmt::print("{}\n", sweep.points[k].folder);
  fmt::print("# points         {} in {} chains, over {}\n", sweep.points.size(),
             sweep.chains.size(), fmt::join(sweep.keys, ", "));
  fmt::print("# steps          {:.4g} million disk-steps\n", disk_steps / 1e6);
  fmt::print("# estimated time {} to {} on one core; the longest chain {} to {}\n",
             time_text(all.least), time_text(all.most), time_text(longest.least),
             time_text(longest.most));
  return 0;
}

}  // namespace bagnold
