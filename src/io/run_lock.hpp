// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "src/io/descriptor.hpp"

namespace bagnold::io {

/// Keeps an output folder for one process: a batch system may lose a child that goes on writing.
/// Holds flock(2) on `folder/.lock`, which tells host and process. The system lets go of it when
/// the process ends, however it ends; the file stays. Does not survive exec.
class RunLock {
 public:
  /// InputError: another process holds it (host and pid are told). FileError: the lock file cannot
  /// be made, or the file system has no locks.
  explicit RunLock(std::filesystem::path const& folder);

 private:
  Descriptor file_;
};

}  // namespace bagnold::io
