// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace bagnold {

/// Number of cores within the CPU quota of this process: the least quota of its control groups and
/// their parents, of version 1 and 2; infinity if there is none. `root` is "/", or a tree that
/// stands for it.
double cpu_quota(std::filesystem::path const& root = "/");

}  // namespace bagnold
