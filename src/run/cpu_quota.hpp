// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace bagnold {

/// Cores worth of time that the control groups of this process allow: the least quota of its groups
/// and their parents, of version 1 and 2; infinity where there is none. `root` is "/", or a tree
/// that stands for it.
double cpu_quota(std::filesystem::path const& root = "/");

}  // namespace bagnold
