// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace bagnold {

// None of these throws: that nobody can read a message is no reason to end a run.

/// "bagnold: MESSAGE" on stderr.
void say(std::string const& message);

/// A warning on stderr, quiet or not; nothing for no message.
void warn(std::string const& message);

/// Why a run ends whose threads cannot all be made.
std::string no_more_threads(int threads);

/// What a run says that is stopped while its start is made.
std::string stopped_before_the_first_step(std::filesystem::path const& folder);

}  // namespace bagnold
