// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_memory.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstring>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

/// HDF5 takes two files of one name, open at once, for the same file.
std::string name_in_memory() {
  static std::atomic<unsigned long> count = 0;
  return "memory " + std::to_string(++count);
}

void require(bool good) {
  if (!good) throw FileError(fmt::format("cannot build an HDF5 file in memory: {}", hdf5_reason()));
}

// HDF5 would copy the image three times; by these calls its core driver works on ours, which it
// only reads. (H5LTopen_file_image does the same, but loses memory where the opening fails.)

void* lend(std::size_t, H5FD_file_image_op_t, void* ours) { return ours; }
void* keep(void* to, void const* from, std::size_t size, H5FD_file_image_op_t, void*) {
  return to == from ? to : std::memcpy(to, from, size);
}
void* refuse_to_grow(void*, std::size_t, H5FD_file_image_op_t, void*) { return nullptr; }
herr_t keep_ours(void*, H5FD_file_image_op_t, void*) { return 0; }
void* same(void* ours) { return ours; }
herr_t leave(void*) { return 0; }

}  // namespace

Handle create_in_memory(std::size_t increment, bool virtual_datasets) {
  quiet_hdf5();
  Handle const access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access.get(), increment, /*backing_store=*/false) >= 0);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_EARLIEST,
                       virtual_datasets ? H5F_LIBVER_LATEST : H5F_LIBVER_V18);
  auto const creation = without_times(H5P_FILE_CREATE);
  Handle file(H5Fcreate(name_in_memory().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()),
              H5Fclose);
  require(file.valid());
  return file;
}

std::span<std::byte const> content_of(Handle const& file) {
  require(H5Fflush(file.get(), H5F_SCOPE_GLOBAL) >= 0);
  auto const size = H5Fget_file_image(file.get(), nullptr, 0);
  void** memory = nullptr;
  require(size > 0 &&
          H5Fget_vfd_handle(file.get(), H5P_DEFAULT, reinterpret_cast<void**>(&memory)) >= 0);
  return {static_cast<std::byte const*>(*memory), static_cast<std::size_t>(size)};
}

Handle open_in_memory(std::vector<std::byte>& image) {
  quiet_hdf5();
  if (image.empty()) return Handle(-1, H5Fclose);
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.get(), /*increment=*/1 << 20, /*backing_store=*/false);
  H5FD_file_image_callbacks_t calls{lend, keep,  refuse_to_grow, keep_ours,
                                    same, leave, image.data()};
  H5Pset_file_image_callbacks(access.get(), &calls);
  H5Pset_file_image(access.get(), image.data(), image.size());
  return Handle(H5Fopen(name_in_memory().c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
}

}  // namespace bagnold::io
