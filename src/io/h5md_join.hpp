// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "src/io/h5md_file.hpp"

namespace bagnold::io {

/// The content of part k of a trajectory, a whole H5MD file.
using TrajectoryPart = std::function<std::vector<std::byte>(std::size_t k)>;

/// Writes the frames of all parts, in order, to a new file, frame by frame, brings it to the disk,
/// and reads it again: every attribute and dataset must have the hash that the parts have. An older
/// file at `path` is removed first. On failure nothing is left there, and FileError says what to
/// do. Returns the times of the frames, [tau_e].
std::vector<double> join_h5md(std::filesystem::path const& path, TrajectoryHeader const& header,
                              std::size_t parts, TrajectoryPart const& part);

/// visit(state, numbers) for every frame of a file that join_h5md() made, in order; see
/// for_each_frame(). Throws FileError.
void read_h5md(std::filesystem::path const& path,
               std::function<void(State const&, FrameNumbers const&)> const& visit);

}  // namespace bagnold::io
