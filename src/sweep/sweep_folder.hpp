// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "src/io/run_lock.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/run_folder.hpp"
#include "src/sweep/placed_points.hpp"
#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// Folder of a sweep: a copy of its file, points.json with the resolved points (and those that left
/// the file), and a folder for every point, for `bagnold resume`.
class SweepFolder {
 public:
  /// Makes or reopens the folder and locks it against other sweeps. Writes missing files, and makes
  /// points longer where needed. Throws InputError if the folder is in use, holds a run, or a point
  /// cannot be made longer.
  static SweepFolder make(std::filesystem::path const& folder, PlacedPoints const& placed);
  static SweepFolder make(std::filesystem::path const& folder, Sweep const& sweep);

  /// Opens a folder that make() made, without a lock, so that several processes can each do a chain
  /// of it. Throws InputError if there is none, or the sweep has points that it does not have.
  static SweepFolder join(std::filesystem::path const& folder, PlacedPoints const& placed);

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path table() const { return path_ / "sweep.csv"; }
  std::filesystem::path point(std::size_t k) const { return path_ / "points" / names_[k]; }
  std::filesystem::path log(std::size_t k) const { return point(k) / "log.txt"; }
  std::filesystem::path summary(std::size_t k) const { return point(k) / "summary.json"; }

  bool has_results(std::size_t k) const { return std::filesystem::exists(summary(k)); }
  /// True if nothing is left to do: `bagnold resume` joins trajectories and removes their parts.
  bool finished(std::size_t k) const {
    return has_results(k) && io::trajectory_parts(point(k)).empty();
  }
  bool begun(std::size_t k) const { return std::filesystem::exists(log(k)); }
  bool in_use(std::size_t k) const;  ///< by a process

 private:
  SweepFolder(std::filesystem::path const& folder, Sweep const& sweep);
  std::vector<std::size_t> shorter_on_disk(Sweep const& sweep) const;
  void make_longer(Sweep const& sweep, std::vector<std::size_t> const& points,
                   void (*how)(RunFolder const&, Scene const&)) const;
  void write_points(PlacedPoints const& placed) const;
  std::string in_place(std::string const& scene, std::size_t k) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;  ///< of the points' folders
  std::unique_ptr<io::RunLock> lock_;
};

}  // namespace bagnold::sweep
