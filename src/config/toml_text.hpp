// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bagnold {

/// The text of a scene file; of `inputs/NAME` that is not there, of the scene that was installed
/// with the program. Throws InputError if it cannot be read or is over a megabyte.
std::string read_text(std::filesystem::path const& file);

/// TOML text as JSON, for code that nvcc compiles: it does not compile the parser's header. Throws
/// InputError with line and column.
std::string toml_as_json(std::string_view text, std::string const& origin);

/// Refuses bytes that the parser should not be given: control bytes, and bytes beyond ASCII outside
/// comments and strings. Throws InputError with line and column.
void refuse_strange_bytes(std::string_view text, std::string const& origin);

}  // namespace bagnold
