// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/run/status.hpp"

namespace bagnold::sweep {

/// Where the points of a sweep stand, by their folders alone: whoever runs them.
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

  /// On one core, at the pace of the points so far; nothing before one has a pace. A thread each.
  std::optional<double> core_seconds_left() const;
};

/// Of the folder of a sweep, from its points.json; nothing where it holds none. Throws InputError
/// where that is damaged.
std::optional<SweepStatus> status_of_sweep(std::filesystem::path const& folder);

}  // namespace bagnold::sweep
