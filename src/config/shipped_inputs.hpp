// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

namespace bagnold {

/// A file of inputs/, which comes with the program. Searched: `inputs` in the working directory,
/// the source tree of a program that was not installed, `share/bagnold` beside an installed one.
///
/// @param name relative to inputs/, such as "figures/figures.toml"
/// @return no value where it is in none of these
std::optional<std::filesystem::path> find_shipped_input(std::filesystem::path const& name);

}  // namespace bagnold
