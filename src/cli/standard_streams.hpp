// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// Opens /dev/null on each of stdin, stdout and stderr that is closed. Otherwise the first files
/// that are opened would take their numbers, and messages would be written into results.
void open_standard_streams();

/// Prints text on stdout and flushes it; never throws. finish_output() reports failures.
void put(std::string const& text);

/// Flushes stdout. Returns the failure of output since the program began, "" if there was none.
std::string finish_output();

}  // namespace bagnold
