// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace bagnold {

struct Scene;

// None of these throws: a message that cannot be read is no reason to end a run.

/// Prints "bagnold: MESSAGE" on stderr.
void say(std::string const& message);

/// Prints a warning on stderr, quiet or not; nothing for an empty message.
void warn(std::string const& message);

/// Message of a run that ends because not all threads can be made.
std::string no_more_threads(int threads);

/// Message of a run that is stopped while its start is made.
std::string stopped_before_the_first_step(Scene const& scene, std::filesystem::path const& folder);

/// "`bagnold resume DIR`", or "the same program" where a law or a drive is that of a user's
/// program.
std::string resuming(Scene const& scene, std::filesystem::path const& folder);

}  // namespace bagnold
