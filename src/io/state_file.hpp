// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "src/io/hdf5_reader.hpp"
#include "src/io/hdf5_writer.hpp"
#include "src/state/state.hpp"

namespace bagnold::io {

/// Reads a state from the group `/state` of an HDF5 file, see SCHEMA.md. Numbers of any width come
/// as doubles, where that loses nothing. InputError where the file is missing, is not of that form,
/// or its state is impossible: shapes differ, N < 2, a value is not finite, a length is not above
/// 0; with `expected_count`, another N is refused before memory is taken. FileError where it cannot
/// be read. Whether it agrees with the scene is not seen here.
State read_state(std::filesystem::path const& path,
                 std::optional<std::size_t> expected_count = std::nullopt);

/// Replaces the file as a whole. FileError where it cannot be written. The state is not checked:
/// one that went wrong is written to be looked at.
void write_state(std::filesystem::path const& path, State const& state);

/// The group `/state`, as state files and checkpoints hold it.
void put_state(Hdf5Writer& file, State const& state);

/// Its inverse, bit for bit; checks types and shapes but no value.
State get_state(Hdf5Reader const& file, std::optional<std::size_t> expected_count = std::nullopt);

}  // namespace bagnold::io
