// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "src/config/errors.hpp"
#include "src/config/shown.hpp"

namespace bagnold::sweep {

namespace {

constexpr std::size_t most_tasks = 1000;  ///< MaxArraySize is 1001 where nobody raised it

std::int64_t minutes_needed(Sweep const& sweep, SlurmJob const& job) {
  double longest = 0;
  std::size_t const tasks = std::min(sweep.chains.size(), most_tasks);
  std::vector<double> seconds(tasks);
  for (std::size_t k = 0; k < sweep.chains.size(); ++k)
    for (auto const point : sweep.chains[k]) seconds[k % tasks] += job.seconds.at(point);
  for (double const one : seconds) longest = std::max(longest, one);
  return static_cast<std::int64_t>(
      std::ceil(std::clamp(2 * longest / 60 / job.threads, 10.0, 1e7)));
}

std::string head(SlurmJob const& job, std::string const& name, std::string const& log) {
  auto const quoted = [](std::filesystem::path const& path) {  // sbatch knows these alone
    return fmt::format("\"{}\"", path.string());
  };
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --ntasks=1\n"
      "#SBATCH --output={}\n"
      "#SBATCH --open-mode=append\n",
      name, quoted(job.folder / "slurm" / log));
}

std::string call(SlurmJob const& job) {
  return fmt::format("{} sweep {} --out {}", shell_word(job.program.string()),
                     shell_word(job.file.string()), shell_word(job.folder.string()));
}

}  // namespace

std::string shell_word(std::string const& word) {
  std::string quoted = "'";
  for (char const c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

void refuse_slurm_name(std::filesystem::path const& folder) {
  auto const name = std::filesystem::absolute(folder).string();
  auto const strange = [](unsigned char c) {
    return c < 0x20 || c == 0x7f ||
           std::string_view("\"\\%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (std::ranges::any_of(name, strange))
    throw InputError(
        fmt::format("--out {} (with --emit-slurm its whole name must be without \", \\, % and "
                    "control characters, which sbatch reads as its own); choose another",
                    shown(name)));
}

std::string slurm_array(Sweep const& sweep, SlurmJob const& job) {
  std::size_t const chains = sweep.chains.size(), tasks = std::min(chains, most_tasks);
  return head(job, "bagnold", "%a.log") +
         fmt::format(
             "#SBATCH --array=1-{0}\n"
             "#SBATCH --cpus-per-task={1}\n"
             "# Minutes, from an estimate: what is cut off goes on when submitted again.\n"
             "#SBATCH --time={2}\n"
             "# Seconds before the end: time for checkpoints.\n"
             "#SBATCH --signal=TERM@120\n"
             "#SBATCH --requeue\n"
             "\n"
             "# srun passes signals on; a plain child of this shell would get none.\n"
             "failed=0\n"
             "for ((chain = SLURM_ARRAY_TASK_ID; chain <= {3}; chain += {0})); do\n"
             "  srun {4} --chain \"$chain\" --quiet{5}\n"
             "  status=$?\n"
             "  [ \"$status\" -lt 128 ] || exit \"$status\"  # stopped, with a checkpoint\n"
             "  [ \"$status\" = 0 ] || failed=$status\n"
             "done\n"
             "exit \"$failed\"\n",
             tasks, job.threads, minutes_needed(sweep, job), chains, call(job), job.options);
}

std::string slurm_collect(SlurmJob const& job) {
  return head(job, "bagnold-collect", "collect.log") +
         fmt::format("#SBATCH --time=10\n\nsrun {} --collect\n", call(job));
}

}  // namespace bagnold::sweep
