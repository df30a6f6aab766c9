// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

constexpr hsize_t largest_chunk = hsize_t{1} << 28;  ///< [bytes]

constexpr auto rewrite = "write it again as plain numbers into this one file";

/// Bytes that a dataset declares; refuses what overflows 64 bits.
hsize_t declared_bytes(OpenFile const& file, std::string const& path, Shape const& shape,
                       hid_t dataset) {
  Handle type(H5Dget_type(dataset), H5Tclose);
  hsize_t bytes = H5Tget_size(type.get());
  for (auto const length : shape)
    if (__builtin_mul_overflow(bytes, length, &bytes))
      refuse(file, path, "declares " + words(shape) + " values, more than any memory", rewrite);
  return bytes;
}

/// None is safe: where a chunk unpacks to less than its size, HDF5 1.10.8 reads past the end of it
/// (seen with deflate and shuffle), and fletcher32 crashes on chunks of less than 4 bytes (seen).
void check_filters(OpenFile const& file, std::string const& path, hid_t creation) {
  if (H5Pget_nfilters(creation) != 0)
    refuse(file, path, "is compressed or filtered",
           "only plain storage is read: use `h5repack -f NONE OLD.h5 NEW.h5`");
}

/// Moves to the next chunk, the last axis fastest; false after the last.
bool advance(Shape& corner, Shape const& chunk, Shape const& shape) {
  for (auto axis = shape.size(); axis-- > 0;) {
    corner[axis] += chunk[axis];
    if (corner[axis] < shape[axis]) return true;
    corner[axis] = 0;
  }
  return false;
}

/// Every chunk must be there and of its full size: HDF5 reads past the end of shorter ones.
void check_chunks(OpenFile const& file, std::string const& path, hid_t creation, hid_t dataset,
                  Shape const& shape) {
  Shape chunk(shape.size());
  int const rank = H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  if (rank < 0 || static_cast<std::size_t>(rank) != shape.size() ||
      std::ranges::count(chunk, hsize_t{0}) != 0)
    refuse(file, path, "has chunks that do not fit its shape", rewrite);
  auto const bytes = declared_bytes(file, path, chunk, dataset);
  if (bytes > largest_chunk)
    refuse(file, path, "has chunks of " + words(chunk), "use chunks of at most 256 MiB");
  if (std::ranges::count(shape, hsize_t{0}) != 0) return;
  Shape corner(shape.size(), 0);
  do {
    unsigned mask = 0;
    haddr_t address = HADDR_UNDEF;
    hsize_t found = 0;
    auto const status = H5Dget_chunk_info_by_coord(dataset, corner.data(), &mask, &address, &found);
    if (status < 0 || address == HADDR_UNDEF || found != bytes)
      refuse(file, path, "has no whole chunk at " + words(corner), "fill all values");
  } while (advance(corner, chunk, shape));
}

void check_storage(OpenFile const& file, std::string const& path, hid_t creation, hid_t dataset) {
  auto const shape = shape_of(file, path, dataset);
  auto const declared = declared_bytes(file, path, shape, dataset);
  if (declared > file.bytes)
    refuse(file, path,
           fmt::format("declares {} bytes, more than the {} of the file", declared, file.bytes),
           rewrite);
  if (H5Pget_layout(creation) == H5D_CHUNKED)
    check_chunks(file, path, creation, dataset, shape);
  else if (H5Dget_storage_size(dataset) != declared)
    refuse(
        file, path,
        fmt::format("declares {} bytes, but {} are stored", declared, H5Dget_storage_size(dataset)),
        "fill all values");
}

}  // namespace

void refuse(OpenFile const& file, std::string_view path, std::string_view reason,
            std::string_view remedy) {
  throw InputError(fmt::format("{}: {} {}: {}", file.name, path, reason, remedy));
}

bool exists(OpenFile const& file, std::string const& path) {
  for (auto end = path.find('/', 1);; end = path.find('/', end + 1)) {
    auto const part = path.substr(0, end);
    auto const there = H5Lexists(file.id, part.c_str(), H5P_DEFAULT);
    if (there < 0) refuse(file, part, "cannot be read (" + hdf5_reason() + ")", "make it again");
    if (there == 0) return false;
    H5L_info_t link{};
    if (H5Lget_info(file.id, part.c_str(), &link, H5P_DEFAULT) < 0)
      refuse(file, part, "cannot be read (" + hdf5_reason() + ")", "make it again");
    if (link.type != H5L_TYPE_HARD)
      refuse(file, part, "is a soft or external link", "links are not followed: copy the data");
    if (end == std::string::npos) return true;
  }
}

Handle open_dataset(OpenFile const& file, std::string const& path) {
  if (!exists(file, path)) refuse(file, path, "is missing", "write this dataset");
  Handle dataset(H5Dopen2(file.id, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid())
    refuse(file, path, "cannot be opened as a dataset (" + hdf5_reason() + ")", rewrite);
  Handle creation(H5Dget_create_plist(dataset.get()), H5Pclose);
  if (!creation.valid()) refuse(file, path, hdf5_reason(), rewrite);
  // before the shape is asked: that of a virtual dataset is found by opening its sources
  auto const layout = H5Pget_layout(creation.get());
  if (layout != H5D_CONTIGUOUS && layout != H5D_COMPACT && layout != H5D_CHUNKED)
    refuse(file, path, "is a virtual dataset: its values lie in other files", rewrite);
  if (H5Pget_external_count(creation.get()) != 0)
    refuse(file, path, "has external storage: its values lie in other files", rewrite);
  check_filters(file, path, creation.get());
  check_storage(file, path, creation.get(), dataset.get());
  return dataset;
}

void check_number(OpenFile const& file, std::string_view path, hid_t type) {
  std::array const known{H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_IEEE_F32LE, H5T_IEEE_F32BE,
                         H5T_STD_I64LE,  H5T_STD_I64BE,  H5T_STD_I32LE,  H5T_STD_I32BE,
                         H5T_STD_I16LE,  H5T_STD_I16BE,  H5T_STD_I8LE,   H5T_STD_I8BE,
                         H5T_STD_U64LE,  H5T_STD_U64BE,  H5T_STD_U32LE,  H5T_STD_U32BE,
                         H5T_STD_U16LE,  H5T_STD_U16BE,  H5T_STD_U8LE,   H5T_STD_U8BE};
  if (std::ranges::none_of(known, [&](hid_t one) { return H5Tequal(type, one) > 0; }))
    refuse(file, path, "does not hold plain numbers", "write 64-bit floats");
}

void check_text(OpenFile const& file, std::string_view path, hid_t type) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    refuse(file, path, "does not hold text of a fixed length", "write it so");
}

Shape shape_of(OpenFile const& file, std::string_view path, hid_t dataset) {
  Handle space(H5Dget_space(dataset), H5Sclose);
  auto const kind = space.valid() ? H5Sget_simple_extent_type(space.get()) : H5S_NO_CLASS;
  if (kind != H5S_SIMPLE && kind != H5S_SCALAR) refuse(file, path, "holds no values", rewrite);
  int const rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0) refuse(file, path, hdf5_reason(), rewrite);
  Shape shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  return shape;
}

std::string words(Shape const& shape) {
  if (shape.empty()) return "a scalar";
  std::string text;
  for (auto const length : shape) text += fmt::format("[{}]", length);
  return text;
}

}  // namespace bagnold::io
