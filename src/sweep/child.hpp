// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/io/descriptor.hpp"

namespace bagnold::sweep {

/// A process that does not outlive this one: the system kills it (SIGKILL) when this process ends,
/// however it ends. It has no input; its output is added to the log; it may report_share(). It may
/// use all cores that this process was given, even if OpenMP binds this process to one.
class Child {
 public:
  /// Starts command[0], sought in PATH if it has no slash, with its arguments. Throws FileError
  /// where the system refuses.
  Child(std::vector<std::string> const& command, std::filesystem::path const& log);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();  ///< kills it if it still runs

  /// Readable when it reported, hung up when it ended.
  int reports() const { return reports_.get(); }

  /// Last share that it reported since the last call.
  std::optional<double> share();

  /// Exit code of the child once it has ended; 128 + the signal if one killed it.
  std::optional<int> exit_code();

  /// Sends SIGTERM: the child writes a checkpoint and stops.
  void ask_to_stop() const;

 private:
  pid_t pid_ = -1;
  io::Descriptor reports_;
};

}  // namespace bagnold::sweep
