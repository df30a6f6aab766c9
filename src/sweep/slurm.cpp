// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "src/config/errors.hpp"
#include "src/config/shell_word.hpp"
#include "src/config/shown.hpp"

namespace bagnold::sweep {

namespace {

std::int64_t minutes_needed(Sweep const& sweep, SlurmJob const& job, std::size_t tasks) {
  double longest = 0;
  std::vector<double> seconds(tasks);
  for (std::size_t k = 0; k < sweep.chains.size(); ++k)
    for (auto const point : sweep.chains[k]) seconds[k % tasks] += job.seconds.at(point);
  for (double const one : seconds) longest = std::max(longest, one);
  return static_cast<std::int64_t>(
      std::ceil(std::clamp(2 * longest / 60 / job.threads, 10.0, 1e7)));
}

std::string head(SlurmJob const& job, std::string const& name, std::string const& log) {
  auto const quoted = [](std::filesystem::path const& path) {  // the only quotes of sbatch
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
  return fmt::format("{} sweep {} --out {}{}", shell_word(job.program.string()),
                     shell_word(job.file.string()), shell_word(job.folder.string()),
                     job.allow_unstable ? " --allow-unstable" : "");
}

}  // namespace

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

std::size_t slurm_tasks(Sweep const& sweep, SlurmJob const& job) {
  return std::min(sweep.chains.size(), static_cast<std::size_t>(job.most_tasks));
}

std::string slurm_array(Sweep const& sweep, SlurmJob const& job) {
  std::size_t const tasks = slurm_tasks(sweep, job);
  return head(job, "bagnold", "%a.log") +
         fmt::format(
             "#SBATCH --array=1-{tasks}\n"
             "#SBATCH --cpus-per-task={threads}\n"
             "# Minutes, from an estimate: what is cut off goes on when submitted again.\n"
             "#SBATCH --time={minutes}\n"
             "# Seconds before the end: time for checkpoints.\n"
             "#SBATCH --signal=TERM@120\n"
             "#SBATCH --requeue\n"
             "\n"
             "task=\"${{SLURM_ARRAY_JOB_ID:?submit this script with "
             "sbatch}}_$SLURM_ARRAY_TASK_ID\"\n"
             "# An array submitted as 1-K, or 0-K, spreads all chains over its tasks. Any other "
             "list\n"
             "# runs the tasks that it names, as this script was written for {tasks}.\n"
             "first=1 tasks={tasks}\n"
             "if ((SLURM_ARRAY_TASK_MIN <= 1 &&\n"
             "     SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1 == SLURM_ARRAY_TASK_COUNT)); "
             "then\n"
             "  first=$SLURM_ARRAY_TASK_MIN tasks=$SLURM_ARRAY_TASK_COUNT\n"
             "fi\n"
             "\n"
             "# srun passes signals on; a plain child of this shell would get none.\n"
             "failed=0\n"
             "for ((chain = SLURM_ARRAY_TASK_ID - first + 1; chain <= {chains}; chain += tasks)); "
             "do\n"
             "  srun {call} --chain \"$chain\" --quiet{options}\n"
             "  status=$?\n"
             "  if [ \"$status\" -ge 128 ]; then # stopped, with a checkpoint\n"
             "    # A task that was preempted and ends within its GraceTime counts as failed: it "
             "asks to\n"
             "    # be queued again. One that scancel ends has no PreemptTime, or runs no longer.\n"
             "    if scontrol -o show job \"$task\" | grep -Eq 'JobState=RUNNING "
             ".*PreemptTime=[0-9]'; then\n"
             "      scontrol requeue \"$task\"\n"
             "    fi\n"
             "    exit \"$status\"\n"
             "  fi\n"
             "  [ \"$status\" = 0 ] || failed=$status\n"
             "done\n"
             "exit \"$failed\"\n",
             fmt::arg("tasks", tasks), fmt::arg("threads", job.threads),
             fmt::arg("minutes", minutes_needed(sweep, job, tasks)),
             fmt::arg("chains", sweep.chains.size()), fmt::arg("call", call(job)),
             fmt::arg("options", job.options));
}

std::string slurm_collect(SlurmJob const& job) {
  return head(job, "bagnold-collect", "collect.log") +
         fmt::format("#SBATCH --time=10\n\nsrun {} --collect\n", call(job));
}

}  // namespace bagnold::sweep
