// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/h5md_join.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <span>

#include "src/config/errors.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_digest.hpp"
#include "src/io/hdf5_memory.hpp"
#include "src/io/run_apart.hpp"

namespace bagnold::io {
namespace {

/// HDF5 locks what it opens, which some file systems cannot; the folder is locked already.
Handle access_without_locks() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
#if H5_VERSION_GE(1, 12, 1) || (H5_VERSION_GE(1, 10, 7) && !H5_VERSION_GE(1, 11, 0))
  H5Pset_file_locking(access.get(), /*use=*/false, /*ignore_when_disabled=*/true);
#endif
  return access;
}

[[noreturn]] void fail_in_hdf5(char const* action, std::filesystem::path const& path) {
  throw FileError(fmt::format("cannot {} {}: {}; check the disk, then `bagnold resume {}`", action,
                              path.string(), hdf5_reason(),
                              shell_word(path.parent_path().string())));
}

Handle create_on_disk(std::filesystem::path const& path) {
  auto const access = access_without_locks();
  auto const creation = without_times(H5P_FILE_CREATE);
  // H5F_ACC_EXCL: nobody's link at this name is followed
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.get(), access.get()), H5Fclose);
  if (!file.valid()) fail_in_hdf5("create", path);
  return file;
}

/// Hashes of the parts that were joined, and the frames' times.
struct Joined {
  Hdf5Digest digest;
  std::vector<double> time;
};

Joined write_joined(std::filesystem::path const& path, TrajectoryHeader const& header,
                    std::size_t parts, TrajectoryPart const& part) {
  Joined joined;
  H5mdFile whole(create_on_disk(path), header);
  // open before anything is written, so that it is told of every write that fails
  auto const descriptor = open_descriptor(path, O_RDONLY | O_NOFOLLOW);
  if (!descriptor.open()) fail_on("read", path, errno);
  for (std::size_t k = 0; k < parts; ++k) {
    auto image = part(k);
    auto const file = open_in_memory(image);
    if (!file.valid()) fail_in_hdf5("read a part of", path);
    joined.digest.add(file);
    for_each_frame(file, [&](State const& state, FrameNumbers const& numbers) {
      whole.append(state, numbers);
      joined.time.push_back(state.time);
    });
  }
  auto file = whole.close();
  if (!file.close()) fail_in_hdf5("close", path);
  sync_file(descriptor, path);
  return joined;
}

/// HDF5 marks a file that it has open for writing, which readers do not look at: File Consistency
/// Flags, byte 20 of a superblock of version 0.
bool marked_as_closed(std::filesystem::path const& path) {
  bool closed = false;
  for_each_block(path, [&](std::span<std::byte const> block) {
    closed = block.size() > 20 && block[20] == std::byte{0};
    return false;
  });
  return closed;
}

bool reads_back(std::filesystem::path const& path, Hdf5Digest const& expected) {
  if (!marked_as_closed(path)) return false;
  auto const same = run_apart([&] {
    auto const access = access_without_locks();
    Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
    Hdf5Digest found;
    found.add(file);
    return std::vector(found.hashes() == expected.hashes() ? 1 : 0, std::byte{});
  });
  return same && !same->empty();
}

}  // namespace

void read_h5md(std::filesystem::path const& path,
               std::function<void(State const&, FrameNumbers const&)> const& visit) {
  quiet_hdf5();
  auto const access = access_without_locks();
  Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  if (!file.valid()) fail_in_hdf5("read", path);
  for_each_frame(file, visit);
}

std::vector<double> join_h5md(std::filesystem::path const& path, TrajectoryHeader const& header,
                              std::size_t parts, TrajectoryPart const& part) {
  remove_file(path);
  try {
    auto joined = write_joined(path, header, parts, part);
    if (!reads_back(path, joined.digest)) fail_different(path);
    return std::move(joined.time);
  } catch (...) {
    ::unlink(path.c_str());
    throw;
  }
}

}  // namespace bagnold::io
