// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "src/io/run_lock.hpp"

namespace bagnold {

/// The folder a run writes to, locked against other processes, and the names in it.
class RunFolder {
 public:
  /// A folder for a new run: made if it is not there; refused (InputError) if it holds a run,
  /// unless `force`, which removes the old run's files.
  static RunFolder make(std::filesystem::path const& folder, bool force);

  /// The folder of a run begun before. InputError if there is none.
  static RunFolder open(std::filesystem::path const& folder);

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path scene() const { return path_ / "scene.toml"; }
  std::filesystem::path summary() const { return path_ / "summary.json"; }
  std::filesystem::path result() const { return path_ / "result.h5"; }
  std::filesystem::path state() const { return path_ / "state.h5"; }
  std::filesystem::path failed_state() const { return path_ / "failed_state.h5"; }
  std::filesystem::path picture() const { return path_ / "plot.png"; }
  /// Of the replica of this seed; none: of the only system.
  std::filesystem::path trajectory(std::optional<std::int64_t> seed) const;

  /// FileError where the folder was moved or removed since: nothing may be written any more.
  void check() const { lock_->check_folder(); }

  /// Of a finished run: those that a kill right at its end left. Throws FileError.
  void remove_trajectory_parts() const;

 private:
  explicit RunFolder(std::filesystem::path folder);

  std::filesystem::path path_;
  std::unique_ptr<io::RunLock> lock_;
};

/// Whether a folder has a file of a run.
bool holds_run(std::filesystem::path const& folder);

/// Whether a run in a folder has come to its first checkpoint, whole or not, or lost it since.
bool begun(std::filesystem::path const& folder);

}  // namespace bagnold
