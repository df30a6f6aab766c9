// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/status.hpp"

namespace bagnold::sweep {

/// Status of the points of a sweep, by their folders alone, whichever process runs them.
struct SweepStatus {
  struct Point {
    std::string folder;
    RunStatus run;
  };
  std::vector<Point> points;  ///< in the order of the sweep file
  std::size_t left = 0;       ///< points on the disk that are no longer in the file
  std::string holder;         ///< host and process of `bagnold sweep`, if one is at work
  bool for_slurm = false;     ///< job scripts lie in the folder

  std::size_t count(RunStatus::State state) const;
  double share() const;  ///< of the disk-steps of all

  /// Remaining time on one core, at the pace of the points so far, [s]; nothing before a point has
  /// a pace. Points have one thread each.
  std::optional<double> core_seconds_left() const;
};

/// Status of a sweep by its folder, from points.json; nothing where the folder holds none. Throws
/// InputError if that file is damaged.
std::optional<SweepStatus> status_of_sweep(std::filesystem::path const& folder);

}  // namespace bagnold::sweep
