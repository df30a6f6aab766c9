// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace bagnold::io {

/// Runs `work` in a child process, as HDF5 can crash on a damaged file, and returns its result.
/// Nothing where the child died or `work` threw. FileError where no process can be had.
std::optional<std::vector<std::byte>> run_apart(
    std::function<std::vector<std::byte>()> const& work);

}  // namespace bagnold::io
