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
/// All are absolute; entries of PATH that are not are ignored: files in the working directory are
/// data and are never run.
std::vector<std::filesystem::path> pythons();

/// First program of a name in the absolute entries of PATH; empty if there is none.
std::filesystem::path in_path(std::string const& name);

}  // namespace bagnold
