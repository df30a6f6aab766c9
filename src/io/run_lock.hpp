// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/io/descriptor.hpp"

namespace bagnold::io {

/// Keeps an output folder for one process: a batch system may lose a child that goes on writing.
/// Holds flock(2) on `folder/.lock`, which tells host and process. The system lets go of it when
/// the process ends, however it ends; the file stays. Does not survive exec.
///
/// Some file systems have no locks (Lustre without -o flock, NFS without lockd): then nothing is
/// held, and remark() says so. BAGNOLD_LOCKS=off in the environment does without where they hang.
class RunLock {
 public:
  /// InputError: another process holds it (host and pid are told), or BAGNOLD_LOCKS is neither on
  /// nor off. FileError: the lock file cannot be made.
  explicit RunLock(std::filesystem::path const& folder);

  /// Why nothing is held; empty: the lock is, or locks were not wanted.
  std::string const& remark() const { return remark_; }

  /// FileError where the path no longer leads to the folder that was locked: it was moved or
  /// removed, and what stands there may be another run's.
  void check_folder() const;

 private:
  void take();
  void sign() const;

  std::filesystem::path path_;
  Descriptor folder_, file_;
  std::string remark_;
};

/// Host and process that hold the lock of a folder; "" where nobody does, or none can be told.
/// Writes nothing.
std::string lock_holder(std::filesystem::path const& folder);

}  // namespace bagnold::io
