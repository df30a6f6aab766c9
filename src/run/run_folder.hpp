// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "src/io/run_lock.hpp"

namespace bagnold {

/// Folder of a run, locked against other processes, and the names in it.
class RunFolder {
 public:
  /// Folder for a new run: made if it does not exist; refused (InputError) if it holds a run,
  /// unless `force`, which removes the old run's files.
  static RunFolder make(std::filesystem::path const& folder, bool force);

  /// Folder of a run that has begun. InputError if there is none.
  static RunFolder open(std::filesystem::path const& folder);

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path scene() const { return path_ / "scene.toml"; }
  std::filesystem::path summary() const { return path_ / "summary.json"; }
  std::filesystem::path result() const { return path_ / "result.h5"; }
  std::filesystem::path state() const { return path_ / "state.h5"; }
  std::filesystem::path failed_state() const { return path_ / "failed_state.h5"; }
  std::filesystem::path picture() const { return path_ / "plot.png"; }
  /// Trajectory of the replica with this seed; without a seed, that of the only system.
  std::filesystem::path trajectory(std::optional<std::int64_t> seed) const;

  /// Throws FileError if the folder was moved or removed: nothing may be written any more.
  void check() const { lock_->check_folder(); }

 private:
  explicit RunFolder(std::filesystem::path folder);

  std::filesystem::path path_;
  std::unique_ptr<io::RunLock> lock_;
};

/// True if a folder has a file of a run.
bool holds_run(std::filesystem::path const& folder);

/// True if a run in a folder has written a checkpoint, even if it is damaged or lost now.
bool begun(std::filesystem::path const& folder);

}  // namespace bagnold
