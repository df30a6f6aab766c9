// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

// None of these throws: that nobody can read a message is no reason to end a run.

/// "bagnold: MESSAGE" on stderr.
void say(std::string const& message);

/// A warning on stderr, quiet or not; nothing for no message.
void warn(std::string const& message);

/// Text on stdout, as it is, to be read at once. What could not be written is found by
/// finish_output().
void put(std::string const& text);

/// Flushes stdout; what went wrong with it since the program began, "" if nothing.
std::string finish_output();

}  // namespace bagnold
