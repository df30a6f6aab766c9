// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/growing_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/config/errors.hpp"

namespace bagnold::io {

namespace {

[[noreturn]] void fail_to_read(std::string const& path) {
  throw FileError(fmt::format("{} cannot be read: {}", path, hdf5_reason()));
}

/// Shape of an open dataset; empty: it is no dataset, or a single number.
Shape shape_of_set(Handle const& set) {
  Handle const space(H5Dget_space(set.get()), H5Sclose);
  Shape shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
  if (!shape.empty()) H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  return shape;
}

/// Rows of an open dataset, of which it has so many.
Handle selected(Handle const& set, Shape const& shape, hsize_t first) {
  Shape start(shape.size(), 0);
  start.front() = first;
  Handle there(H5Dget_space(set.get()), H5Sclose);
  H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
  return there;
}

}  // namespace

void require_written(bool good, Handle const& at) {
  if (good) return;
  auto const why = hdf5_reason();
  std::string name(4096, '\0');
  auto const length = H5Fget_name(at.get(), name.data(), name.size());
  name.resize(static_cast<std::size_t>(std::clamp<ssize_t>(length, 0, 4095)));
  throw FileError(fmt::format(
      "cannot write {}: {}; check the disk and its space, then `bagnold resume`", name, why));
}

Handle make_growing(Handle const& file, std::string const& path, hid_t stored, Shape const& row,
                    hsize_t rows_in_chunk) {
  Shape shape = row;
  shape.insert(shape.begin(), 0);
  Shape most = shape, chunk = shape;
  most.front() = H5S_UNLIMITED;
  chunk.front() = rows_in_chunk;
  auto const creation = without_times(H5P_DATASET_CREATE);
  H5Pset_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data());
  Handle const space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), most.data()),
                     H5Sclose);
  Handle set(H5Dcreate2(file.get(), path.c_str(), stored, space.get(), H5P_DEFAULT, creation.get(),
                        H5P_DEFAULT),
             H5Dclose);
  require_written(set.valid(), file);
  return set;
}

void append_rows(Handle const& set, hid_t type, void const* values, hsize_t rows) {
  if (rows == 0) return;
  Shape shape = shape_of_set(set);
  auto const first = shape.front();
  shape.front() += rows;
  require_written(H5Dset_extent(set.get(), shape.data()) >= 0, set);
  shape.front() = rows;
  Handle const there = selected(set, shape, first);
  Handle const here(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                    H5Sclose);
  require_written(H5Dwrite(set.get(), type, here.get(), there.get(), H5P_DEFAULT, values) >= 0,
                  set);
}

hsize_t rows_in(Handle const& file, std::string const& path) {
  Handle const set(H5Dopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Dclose);
  auto const shape = shape_of_set(set);
  if (shape.empty()) fail_to_read(path);
  return shape.front();
}

template <class T>
std::vector<T> read_rows(Handle const& file, std::string const& path, hid_t type, hsize_t first,
                         hsize_t count) {
  Handle const set(H5Dopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Dclose);
  Shape shape = shape_of_set(set);
  if (shape.empty() || shape.front() < first + count) fail_to_read(path);
  shape.front() = count;
  hsize_t numbers = 1;
  for (auto const length : shape) numbers *= length;
  std::vector<T> values(numbers);
  if (numbers == 0) return values;
  Handle const there = selected(set, shape, first);
  Handle const here(H5Screate_simple(1, &numbers, nullptr), H5Sclose);
  if (H5Dread(set.get(), type, here.get(), there.get(), H5P_DEFAULT, values.data()) < 0)
    fail_to_read(path);
  return values;
}

template std::vector<double> read_rows(Handle const&, std::string const&, hid_t, hsize_t, hsize_t);
template std::vector<std::int32_t> read_rows(Handle const&, std::string const&, hid_t, hsize_t,
                                             hsize_t);
template std::vector<std::int64_t> read_rows(Handle const&, std::string const&, hid_t, hsize_t,
                                             hsize_t);

}  // namespace bagnold::io
