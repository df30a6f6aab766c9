// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "src/io/descriptor.hpp"

namespace bagnold::io {

/// Where a file is written before it is given its name: `path` with `.tmp` behind it.
std::filesystem::path temporary_of(std::filesystem::path const& path);

/// Removes a file, or a link, that may be there; throws FileError.
void remove_file(std::filesystem::path const& path);

/// Brings what was written to an open file to the disk; throws FileError where the disk reports a
/// fault.
void sync_file(Descriptor const& file, std::filesystem::path const& path);

/// Throws the FileError of a file that the disk did not keep.
[[noreturn]] void fail_different(std::filesystem::path const& path);

/// Writes a new file, content and then tail, brings it to the disk, reads it again and compares. An
/// older file at `path` is removed first. On failure nothing is left there, and FileError says what
/// to do.
void write_verified(std::filesystem::path const& path, std::span<std::byte const> content,
                    std::span<std::byte const> tail = {});

/// rename(2) inside one folder; throws FileError.
void rename_file(std::filesystem::path const& from, std::filesystem::path const& to);

/// Brings the names in a folder to the disk; throws FileError where the disk reports a fault.
void sync_folder(std::filesystem::path const& folder);

/// Replaces a file as a whole: after a kill at any instant `path` holds either the old content or
/// the new one, content and then tail. They go to `path.tmp`, are verified, and are renamed. On
/// failure the temporary is removed, the old file is untouched, and FileError says what to do.
void replace_file(std::filesystem::path const& path, std::span<std::byte const> content,
                  std::span<std::byte const> tail = {});
inline void replace_text(std::filesystem::path const& path, std::string_view text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

/// Shows a regular file block by block until `see` says false. Throws FileError as read_file does.
void for_each_block(std::filesystem::path const& path,
                    std::function<bool(std::span<std::byte const>)> const& see);

/// The whole of a regular file. Throws FileError: not there, no permission, not a regular file, or
/// bigger than half the memory of the machine.
std::vector<std::byte> read_file(std::filesystem::path const& path);

}  // namespace bagnold::io
