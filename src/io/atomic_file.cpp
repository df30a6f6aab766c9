// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

/// Bytes asked of the system in one call: Linux moves at most 2 GiB at once.
constexpr std::size_t block_bytes = std::size_t{1} << 30;

void write_all(Descriptor const& file, std::filesystem::path const& path,
               std::span<std::byte const> content) {
  while (!content.empty()) {
    auto const wanted = std::min(content.size(), block_bytes);
    auto const written = ::write(file.get(), content.data(), wanted);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_on("write", path, written == 0 ? ENOSPC : errno);
    content = content.subspan(static_cast<std::size_t>(written));
  }
}

/// Some file systems have nothing to synchronise and say EINVAL: that is no fault of the file.
bool sync_failed(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINVAL || errno == ENOTSUP) return false;
    if (errno != EINTR) return true;
  }
  return false;
}

/// NFS and quotas may tell of a full disk only here. After EINTR Linux has closed the file.
void close_checked(Descriptor file, std::filesystem::path const& path) {
  if (::close(file.release()) != 0 && errno != EINTR) fail_on("close", path, errno);
}

struct stat status_of(Descriptor const& file, std::filesystem::path const& path) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail_on("read", path, errno);
  return status;
}

Descriptor open_regular(std::filesystem::path const& path) {
  // O_NONBLOCK: a pipe at this name does not hold us up before it is refused
  auto file = open_descriptor(path, O_RDONLY | O_NONBLOCK);
  if (!file.open()) fail_on("read", path, errno);
  if (!S_ISREG(status_of(file, path).st_mode))
    throw FileError(fmt::format("cannot read {}: it is not a file: check the path", path.string()));
  return file;
}

std::uint64_t size_of(Descriptor const& file, std::filesystem::path const& path) {
  return static_cast<std::uint64_t>(status_of(file, path).st_size);
}

/// The bytes read, at most as many as there is room for; 0 at the end.
std::size_t read_some(Descriptor const& file, std::filesystem::path const& path,
                      std::span<std::byte> room) {
  while (true) {
    auto const got = ::read(file.get(), room.data(), std::min(room.size(), block_bytes));
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) fail_on("read", path, errno);
  }
}

/// True if a file holds content and then tail, and nothing else.
bool holds(std::filesystem::path const& path, std::span<std::byte const> content,
           std::span<std::byte const> tail) {
  bool same = true;
  for_each_block(path, [&](std::span<std::byte const> block) {
    while (same && !block.empty()) {
      if (content.empty()) std::swap(content, tail);
      auto const piece = std::min(block.size(), content.size());
      same = piece != 0 && std::memcmp(block.data(), content.data(), piece) == 0;
      block = block.subspan(piece);
      content = content.subspan(piece);
    }
    return same;
  });
  return same && content.empty() && tail.empty();
}

void write_and_compare(std::filesystem::path const& path, std::span<std::byte const> content,
                       std::span<std::byte const> tail) {
  // O_EXCL: nobody's link at this name is followed
  auto file = open_descriptor(path, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.open()) fail_on("create", path, errno);
  write_all(file, path, content);
  write_all(file, path, tail);
  sync_file(file, path);
  close_checked(std::move(file), path);

  if (!holds(path, content, tail)) fail_different(path);
}

}  // namespace

std::filesystem::path temporary_of(std::filesystem::path const& path) {
  auto temporary = path;
  return temporary += ".tmp";
}

void remove_file(std::filesystem::path const& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail_on("remove the old", path, errno);
}

void sync_file(Descriptor const& file, std::filesystem::path const& path) {
  if (sync_failed(file.get())) fail_on("bring to the disk", path, errno);
  // a hint to read from the disk from now on, not from memory; its failure means nothing
  (void)::posix_fadvise(file.get(), 0, 0, POSIX_FADV_DONTNEED);
}

void fail_different(std::filesystem::path const& path) {
  throw FileError(fmt::format(
      "{} reads back different from what was written: check the disk, or use another folder",
      path.string()));
}

void write_verified(std::filesystem::path const& path, std::span<std::byte const> content,
                    std::span<std::byte const> tail) {
  remove_file(path);
  try {
    write_and_compare(path, content, tail);
  } catch (...) {
    ::unlink(path.c_str());
    throw;
  }
}

void rename_file(std::filesystem::path const& from, std::filesystem::path const& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail_on("give its name to", to, errno);
}

void sync_folder(std::filesystem::path const& folder) {
  auto const name = folder.empty() ? std::filesystem::path(".") : folder;
  auto const file = open_descriptor(name, O_RDONLY | O_DIRECTORY);
  if (!file.open() && errno == EACCES) return;  // may be entered and written, but not listed
  if (!file.open()) fail_on("open the folder", name, errno);
  if (sync_failed(file.get())) fail_on("bring to the disk the folder", name, errno);
}

void replace_file(std::filesystem::path const& path, std::span<std::byte const> content,
                  std::span<std::byte const> tail) {
  auto const temporary = temporary_of(path);
  write_verified(temporary, content, tail);
  try {
    rename_file(temporary, path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(path.parent_path());
}

void for_each_block(std::filesystem::path const& path,
                    std::function<bool(std::span<std::byte const>)> const& see) {
  auto const file = open_regular(path);
  std::vector<std::byte> block(std::size_t{1} << 20);
  while (true) {
    auto const got = read_some(file, path, block);
    if (got == 0 || !see(std::span(block).first(got))) return;
  }
}

std::vector<std::byte> read_file(std::filesystem::path const& path) {
  auto const file = open_regular(path);
  auto const size = size_of(file, path);
  auto const memory = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                      static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  if (size > memory / 2)
    throw FileError(fmt::format(
        "cannot read {}: its {} bytes are over half the memory here ({} bytes): check the file",
        path.string(), size, memory));

  std::vector<std::byte> content(size);
  std::size_t done = 0;
  while (done < size) {
    auto const got = read_some(file, path, std::span(content).subspan(done));
    if (got == 0) break;  // cut short meanwhile: what is there is returned
    done += got;
  }
  content.resize(done);
  return content;
}

}  // namespace bagnold::io
