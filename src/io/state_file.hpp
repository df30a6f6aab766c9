// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/io/hdf5_reader.hpp"
#include "src/io/hdf5_writer.hpp"
#include "src/state/state.hpp"

namespace bagnold::io {

/// Reads the states in the group `/state` of an HDF5 file, see docs/files.md: one, or R where the
/// datasets have a leading axis. Numbers of any width come as doubles, where that loses nothing.
/// InputError where the file is missing, is not of that form, or a state is impossible: shapes
/// differ, R < 1, N < 2, a value is not finite, a length is not above 0; with `expected_count`,
/// another N is refused before memory is taken. FileError where it cannot be read. Whether it
/// agrees with the scene is not seen here.
///
/// A file with a seal must be as it was written. One without (made or changed by others) is read in
/// a child process first, since a damaged file can crash HDF5.
std::vector<State> read_states(std::filesystem::path const& path,
                               std::optional<std::size_t> expected_count = std::nullopt);

/// Replaces the file as a whole, sealed: R states of equal N, box, offset, time and rate, with a
/// leading axis R where there are several. FileError where it cannot be written. The states are not
/// checked: one that went wrong is written to be looked at. Each array is freed when it is in the
/// file.
void write_states(std::filesystem::path const& path, std::vector<State> states);

/// The group `state` in the group `at` ("": the root), as state files and checkpoints hold it.
/// Throws std::logic_error for states that cannot share a file.
void put_states(Hdf5Writer& file, std::vector<State> states, std::string const& at = "");

/// Reads the states that put_states() wrote, bit for bit; checks types and shapes but no value.
std::vector<State> get_states(Hdf5Reader const& file, std::string const& at = "",
                              std::optional<std::size_t> expected_count = std::nullopt);

}  // namespace bagnold::io
