// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// Job for the scripts of a sweep.
struct SlurmJob {
  std::filesystem::path program;
  std::filesystem::path file;      ///< the sweep file
  std::filesystem::path folder;    ///< of the sweep
  std::string options;             ///< for every point, e.g. "--threads 4"
  bool allow_unstable = false;     ///< accept time steps beyond the stability, in both scripts
  int threads = 1;                 ///< cores a point uses
  std::int64_t most_tasks = 1000;  ///< of an array
  std::vector<double> seconds;     ///< that each point may take on one core at most, [points]
};

/// Throws InputError for a folder whose name sbatch would not take literally: it is in comments of
/// the scripts, where a new line ends the comment, and sbatch replaces patterns of letters in it.
void refuse_slurm_name(std::filesystem::path const& folder);

/// Tasks of the array: one for each chain, up to the limit.
std::size_t slurm_tasks(Sweep const& sweep, SlurmJob const& job);

/// Script of an array of slurm_tasks() that runs `bagnold sweep FILE --out DIR --chain K`; beyond
/// that many chains a task does several in turn. Submitted as `--array=1-K` all chains are spread
/// over its K tasks. The wall time is twice that of the longest task, at least 10 minutes. A task
/// that is preempted asks to be queued again.
std::string slurm_array(Sweep const& sweep, SlurmJob const& job);

/// Script of the step after it, which writes the tables.
std::string slurm_collect(SlurmJob const& job);

}  // namespace bagnold::sweep
