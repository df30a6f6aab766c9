// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/io/descriptor.hpp"

namespace bagnold::sweep {

/// A process of ours that does not outlive us: the system kills it (SIGKILL) when this process
/// ends, however it ends. It reads nothing; what it prints is added to the log; it may
/// report_share(). It may use all cores that this process was given, whatever OpenMP binds to one.
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

  /// The last share it told since the last call.
  std::optional<double> share();

  /// Its exit code once it has ended, 128 + the signal that killed it.
  std::optional<int> exit_code();

  /// SIGTERM: write a checkpoint and stop.
  void ask_to_stop() const;

 private:
  pid_t pid_ = -1;
  io::Descriptor reports_;
};

}  // namespace bagnold::sweep
