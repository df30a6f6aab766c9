// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "src/run/machine.hpp"
#include "src/sweep/monitor.hpp"
#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

struct SweepOptions {
  /// Program called as `PROGRAM resume FOLDER --threads N` for each point; without a slash it is
  /// searched in PATH. A program with its own laws names itself here and implements that command.
  std::filesystem::path program = "bagnold";
  Machine machine;                  ///< of each point; threads = 0: one
  int jobs = 0;                     ///< points at a time; 0: as many as the cores take
  std::int64_t tasks = 0;           ///< of Slurm's array at most; 0: as many as Slurm takes
  SweepMonitor* monitor = nullptr;  ///< may be null
};

/// End of a call to run a sweep.
enum class SweepEnd {
  done,
  incomplete,  ///< points failed, or have no result yet
  stopped      ///< by the monitor, with checkpoints: the same call continues
};

/// Runs all points of a sweep into a folder, which is made, and writes the tables sweep.csv and
/// sweep.h5, as `bagnold sweep` does; continues where an earlier call ended. If the sweep has
/// gained points or strain since, existing results are kept (placed_points.hpp). Points are
/// processes of their own, which end with this one. Failures and their reasons go to stderr.
///
/// Throws InputError if the folder is in use, holds a run, or a sweep of which no point is left;
/// FileError.
SweepEnd run(Sweep const& sweep, std::filesystem::path const& folder,
             SweepOptions const& options = {});

/// Runs one chain of a sweep, counted from 1, and writes no table: several processes can each do a
/// chain of a folder that emit_slurm() prepared. Throws InputError also if there is no such chain.
SweepEnd run_chain(Sweep const& sweep, std::filesystem::path const& folder, std::int64_t chain,
                   SweepOptions const& options = {});

/// Writes the tables of finished points, as run() does at its end; runs nothing. Returns
/// `incomplete` if a point has no result.
SweepEnd collect(Sweep const& sweep, std::filesystem::path const& folder,
                 SweepOptions const& options = {});

/// Threads of each point.
int threads_of(SweepOptions const& options);

/// Words behind `PROGRAM resume FOLDER`.
std::vector<std::string> point_words(SweepOptions const& options);

}  // namespace bagnold::sweep
