// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bagnold {

/// Pythons to draw with, the best first: the one that BAGNOLD_PYTHON names, by its path or as found
/// in PATH; else the one beside the program, as in the environment that pip installed it into, the
/// system's, and the first in PATH.
///
/// All are absolute, and entries of PATH that are not are passed over: what lies in the folder
/// where the user stands is data, whoever put it there, and is not run.
std::vector<std::filesystem::path> pythons();

/// The first program of a name in PATH, of entries that are absolute; none: empty.
std::filesystem::path in_path(std::string const& name);

}  // namespace bagnold
