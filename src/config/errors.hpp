// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace bagnold {

/// A mistake in the user's input; the message names key, value, reason and remedy. Exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Numbers of the simulation beyond the range in which they are meaningful. Exit code 3.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or folder could not be read or written. Exit code 4.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace bagnold
