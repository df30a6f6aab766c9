// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/io/hdf5_handle.hpp"

namespace bagnold::io {

/// Throws FileError, with HDF5's reason, unless what was written is good. at: an open file, or what
/// lies in it.
void require_written(bool good, Handle const& at);

/// A dataset [0][row...] that grows along its first axis, kept in chunks of so many rows.
Handle make_growing(Handle const& file, std::string const& path, hid_t stored, Shape const& row,
                    hsize_t rows_in_chunk);

/// Adds rows behind the last one; values: [rows][row...].
void append_rows(Handle const& set, hid_t type, void const* values, hsize_t rows);

/// How many rows a dataset has. Throws FileError.
hsize_t rows_in(Handle const& file, std::string const& path);

/// Rows first .. first + count - 1, [count][row...]. T: of the same width as `type`. Throws
/// FileError.
template <class T>
std::vector<T> read_rows(Handle const& file, std::string const& path, hid_t type, hsize_t first,
                         hsize_t count);

extern template std::vector<double> read_rows(Handle const&, std::string const&, hid_t, hsize_t,
                                              hsize_t);
extern template std::vector<std::int32_t> read_rows(Handle const&, std::string const&, hid_t,
                                                    hsize_t, hsize_t);
extern template std::vector<std::int64_t> read_rows(Handle const&, std::string const&, hid_t,
                                                    hsize_t, hsize_t);

}  // namespace bagnold::io
