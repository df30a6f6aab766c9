// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bagnold::io {

/// Paths in a folder whose whole name matches `pattern`, a regular expression; none where
/// it cannot be read.
std::vector<std::filesystem::path> entries(std::filesystem::path const& folder,
                                           std::string const& pattern);

/// The folders of parts in a run's folder: trajectory.parts, trajectory_SEED.parts. Those that
/// stand beside a NAME.h5md have been joined.
std::vector<std::filesystem::path> trajectory_parts(std::filesystem::path const& folder);

/// True if all results of a run are there: the summary, and each trajectory whole.
bool run_finished(std::filesystem::path const& folder);

}  // namespace bagnold::io
