// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/analysis/request.hpp"

namespace bagnold {

/// On what a run runs; none of it changes its bits.
struct Machine {
  std::string backend;  ///< "" chooses
  int threads = 0;      ///< 0 chooses
};

struct RunOptions {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;  ///< "table.key=value"
  std::filesystem::path folder;        ///< "": results/NAME of the scene file
  Machine machine;
  bool quiet = false;
  bool force = false;
  bool allow_unstable = false;
};

struct ResumeOptions {
  std::filesystem::path folder;
  Machine machine;
  bool quiet = false;
};

struct AnalyseOptions {
  std::string kind;
  std::filesystem::path sweep;   ///< folder or sweep.h5
  std::filesystem::path prefix;  ///< of the files written; "": the folder of the sweep and the kind
  analysis::Request request;
  bool quiet = false;
};

/// A line on stderr, quiet or not; nothing for no message.
void warn(std::string const& message);

// Each returns the exit code: 0 done, 130 or 143 interrupted with a checkpoint written. What goes
// wrong is thrown: InputError, NumericalError, FileError.
int run_command(RunOptions const& options);
int resume_command(ResumeOptions const& options);
int validate_command(RunOptions const& options);
int info_command();
int analyse_command(AnalyseOptions const& options);

/// What --help says of the kinds of analysis.
std::string analyse_kinds();

}  // namespace bagnold
