// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/emit_slurm.hpp"

#include <fmt/format.h>

#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/messages.hpp"
#include "src/sweep/placed_points.hpp"
#include "src/sweep/slurm.hpp"
#include "src/sweep/slurm_limit.hpp"
#include "src/sweep/sweep_times.hpp"

namespace bagnold::sweep {

SlurmScripts emit_slurm(Sweep const& sweep, std::filesystem::path const& name, bool allow_unstable,
                        SweepOptions const& options) {
  refuse_slurm_name(name);
  auto const placed = place_points(sweep, name);
  auto const folder = SweepFolder::make(name, placed);
  if (auto const text = changes(placed); !text.empty()) say(text);
  std::string words;
  for (auto const& word : point_words(options)) words += fmt::format(" {}", shell_word(word));
  std::vector<double> seconds;
  for (auto const& time : times_of_points(sweep).each) seconds.push_back(time.most);
  SlurmJob const job{.program = options.program,
                     .file = std::filesystem::absolute(sweep.origin),
                     .folder = folder.path(),
                     .options = words,
                     .allow_unstable = allow_unstable,
                     .threads = threads_of(options),
                     .most_tasks = options.tasks > 0 ? options.tasks : most_array_tasks(),
                     .seconds = std::move(seconds)};
  std::filesystem::create_directories(folder.path() / "slurm");
  SlurmScripts const scripts{folder.path() / "points.slurm", folder.path() / "collect.slurm",
                             slurm_tasks(sweep, job)};
  io::replace_text(scripts.points, slurm_array(sweep, job));
  io::replace_text(scripts.collect, slurm_collect(job));
  return scripts;
}

}  // namespace bagnold::sweep
