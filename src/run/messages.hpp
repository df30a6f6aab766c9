// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

// None of these throws: that nobody can read a message is no reason to end a run.

/// "bagnold: MESSAGE" on stderr.
void say(std::string const& message);

/// A warning on stderr, quiet or not; nothing for no message.
void warn(std::string const& message);

}  // namespace bagnold
