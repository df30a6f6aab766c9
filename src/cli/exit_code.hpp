// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

#include "src/run/monitor.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold {

/// Exit codes of the program unless a signal stops it; docs/scenes.md tells users.
enum ExitCode {
  done = 0,
  points_failed = 1,  ///< of a sweep
  bad_input = 2,
  numerical_failure = 3,
  file_failure = 4,
  internal_error = 5
};

/// Prints a failure and returns the exit code of the program.
ExitCode exit_code_of(std::exception_ptr const& failure);

/// Code of a run or a sweep that ended without a failure thrown: 128 + the signal that stopped it.
int exit_code_of(RunEnd end);
int exit_code_of(sweep::SweepEnd end);

/// Exit code for one of the Python package: the same code if the package defines it or a signal
/// ended it, otherwise internal_error.
int exit_code_of_package(int code);

}  // namespace bagnold
