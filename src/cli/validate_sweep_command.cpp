// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/cli/commands.hpp"
#include "src/config/errors.hpp"
#include "src/sweep/checked_sweep.hpp"
#include "src/sweep/sweep_times.hpp"

namespace bagnold {

int validate_sweep_command(ValidateOptions const& options) {
  if (!options.overrides.empty())
    throw InputError(fmt::format("--set {}: does not go with a sweep; change {}",
                                 options.overrides.front(), options.scene_file.string()));
  auto const sweep = sweep::read_checked_sweep(options.scene_file, options.allow_unstable);
  if (auto const note = sweep::rising_chain_note(sweep); !note.empty()) say("note: " + note);
  for (std::size_t k = 0; k < sweep.points.size(); ++k) fmt::print("{}\n", sweep.points[k].folder);
  fmt::print("# points         {} in {} chains, over {}\n", sweep.points.size(),
             sweep.chains.size(), fmt::join(sweep.keys, ", "));
  fmt::print("# steps          {:.4g} million disk-steps\n", disk_steps(sweep) / 1e6);
  if (options.no_time) return 0;
  auto const times = times_of_points(sweep);
  RunTime const longest = longest_chain(sweep, times);
  RunTime const all = times.sum();
  fmt::print("# estimated time {} ({} to {}) on one core; the longest chain {} ({} to {})\n",
             time_text(all.expected), time_text(all.least), time_text(all.most),
             time_text(longest.expected), time_text(longest.least), time_text(longest.most));
  fmt::print("#                {}\n", times.how);
  return 0;
}

}  // namespace bagnold
