// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// /dev/null on each of stdin, stdout and stderr that is closed: else the first files that are
/// opened would take their numbers, and messages would be written into results.
void open_standard_streams();

/// Text on stdout, as it is, to be read at once; never throws. What could not be written is found
/// by finish_output().
void put(std::string const& text);

/// Flushes stdout; what went wrong with it since the program began, "" if nothing.
std::string finish_output();

}  // namespace bagnold
