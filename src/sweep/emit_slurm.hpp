// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

#include "src/sweep/run_sweep.hpp"

namespace bagnold::sweep {

/// Job scripts of a sweep, in its folder.
struct SlurmScripts {
  std::filesystem::path points;   ///< an array of tasks
  std::filesystem::path collect;  ///< to be submitted behind it; writes the tables
  std::size_t tasks = 0;          ///< of the array
};

/// Prepares the folder of a sweep, which was read from the file `sweep.origin`, and writes the job
/// scripts that run it with `options`; runs only trials for the wall time. The scripts call
/// `PROGRAM sweep FILE --out FOLDER`, with --allow-unstable if that is given. Throws InputError as
/// run() does, and for a folder whose name sbatch does not accept; FileError.
SlurmScripts emit_slurm(Sweep const& sweep, std::filesystem::path const& folder,
                        bool allow_unstable, SweepOptions const& options = {});

}  // namespace bagnold::sweep
