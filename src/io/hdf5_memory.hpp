// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "src/io/hdf5_handle.hpp"

namespace bagnold::io {

/// A new HDF5 file in memory: no disk can fail while it is built. The form is the oldest that any
/// HDF5 from 1.8 on reads, from 1.10 on where datasets may be virtual; no times are kept, so equal
/// content gives equal bytes. increment: room added at once, [bytes]. Throws FileError (in
/// practice: out of memory).
Handle create_in_memory(std::size_t increment = std::size_t{1} << 20,
                        bool virtual_datasets = false);

/// The file as it would be on the disk: HDF5's own memory, while it is open and nothing is added.
/// Throws FileError.
std::span<std::byte const> content_of(Handle const& file);

/// Opens a file whose bytes are in memory, for reading; they must outlive the handle, which is not
/// valid where HDF5 refuses them.
Handle open_in_memory(std::vector<std::byte>& image);

}  // namespace bagnold::io
