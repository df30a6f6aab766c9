// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bagnold::io {

// A seal is a line of 64 bytes behind the last byte of an HDF5 file, which HDF5 does not look at:
// the length and the xxh3 of all before it. It is checked before HDF5 sees the file, since a
// damaged one can crash the library; it covers attributes and HDF5's own tables too.

inline constexpr std::size_t seal_bytes = 64;

/// Seal that belongs behind a content.
std::string seal_of(std::span<std::byte const> content);

/// Appends it.
void add_seal(std::vector<std::byte>& content);

/// Replaces a file as a whole (replace_file) by a content and its seal. Throws FileError.
void replace_sealed(std::filesystem::path const& path, std::span<std::byte const> content);

/// True if a seal, right or wrong, stands behind a content.
bool has_seal(std::span<std::byte const> content);

/// Takes the seal off a sealed content. Returns an empty text, or why the seal is not true (the
/// content is then left as it was): the file was cut short, changed or never finished.
std::string remove_seal(std::vector<std::byte>& content);

/// True if a file is there and its seal is right. Throws FileError where it cannot be read.
bool is_sealed(std::filesystem::path const& path);

}  // namespace bagnold::io
