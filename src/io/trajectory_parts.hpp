// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bagnold::io {

/// What in a folder has a name that matches all of `pattern`, a regular expression; nothing where
/// it cannot be read.
std::vector<std::filesystem::path> entries(std::filesystem::path const& folder,
                                           std::string const& pattern);

/// The folders of parts in a run's folder: trajectory.parts, trajectory_SEED.parts. Those that
/// stand beside a NAME.h5md have been joined.
std::vector<std::filesystem::path> trajectory_parts(std::filesystem::path const& folder);

/// Whether all results of a run are there: the summary, and each trajectory whole.
bool run_finished(std::filesystem::path const& folder);

}  // namespace bagnold::io
