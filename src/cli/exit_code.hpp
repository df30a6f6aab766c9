// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

#include "src/run/monitor.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold {

/// How the program ends where it is not stopped by a signal; docs/scenes.md tells users.
enum ExitCode {
  done = 0,
  points_failed = 1,  ///< of a sweep
  bad_input = 2,
  numerical_failure = 3,
  file_failure = 4,
  internal_error = 5
};

/// Says what went wrong, and with which code that ends the program.
ExitCode exit_code_of(std::exception_ptr const& failure);

/// Code of a run or a sweep that ended without a failure thrown: 128 + the signal that stopped it.
int exit_code_of(RunEnd end);
int exit_code_of(sweep::SweepEnd end);

/// That of the Python package, where it is one of ours; internal_error where it ended otherwise.
int exit_code_of_package(int code);

}  // namespace bagnold
