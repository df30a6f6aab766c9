// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace bagnold {

/// The program's last message in a log of its standard error; "" where there is none.
///
/// @param before bytes at the start of the log that do not count
std::string last_words(std::filesystem::path const& log, std::uintmax_t before = 0);

}  // namespace bagnold
