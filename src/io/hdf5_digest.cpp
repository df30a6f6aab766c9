// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

void require_read(bool good, std::string const& path) {
  if (!good) throw FileError(fmt::format("{} cannot be read: {}", path, hdf5_reason()));
}

using Names = std::vector<std::string>;

constexpr std::size_t block = std::size_t{1} << 20;  ///< read at once, about, [bytes]

herr_t list_attribute(hid_t, char const* name, H5A_info_t const*, void* names) {
  static_cast<Names*>(names)->emplace_back(name);
  return 0;
}

herr_t list_member(hid_t, char const* name, H5L_info_t const*, void* names) {
  static_cast<Names*>(names)->emplace_back(name);
  return 0;
}

struct Extent {
  Shape now, most;
};

Extent extent_of(Handle const& space, std::string const& path) {
  int const rank = space.valid() ? H5Sget_simple_extent_ndims(space.get()) : -1;
  require_read(rank >= 0, path);
  Extent extent{Shape(static_cast<std::size_t>(rank)), Shape(static_cast<std::size_t>(rank))};
  H5Sget_simple_extent_dims(space.get(), extent.now.data(), extent.most.data());
  return extent;
}

std::vector<std::byte> room_for(Shape const& shape, Handle const& type) {
  std::size_t bytes = H5Tget_size(type.get());
  for (auto const length : shape) bytes *= length;
  return std::vector<std::byte>(bytes);
}

void add_shape(Xxh3& hash, std::span<hsize_t const> shape) { hash.add(std::as_bytes(shape)); }

}  // namespace

void Hdf5Digest::add(Handle const& file) {
  Handle const root(H5Gopen2(file.get(), "/", H5P_DEFAULT), H5Gclose);
  add_object(root, "/");
}

void Hdf5Digest::add_object(Handle const& object, std::string const& path) {
  require_read(object.valid(), path);
  add_attributes(object, path);
  if (H5Iget_type(object.get()) == H5I_DATASET) return add_dataset(object, path);
  Names names;
  require_read(
      H5Literate(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, list_member, &names) >= 0,
      path);
  for (auto const& name : names)
    add_object(Handle(H5Oopen(object.get(), name.c_str(), H5P_DEFAULT), H5Oclose),
               (path == "/" ? path : path + "/") + name);
}

void Hdf5Digest::add_attributes(Handle const& object, std::string const& path) {
  Names names;
  require_read(
      H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, list_attribute, &names) >= 0,
      path);
  for (auto const& name : names) {
    auto const where = path + "@" + name;
    Handle const attribute(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
    require_read(attribute.valid(), where);
    Handle const type(H5Aget_type(attribute.get()), H5Tclose);
    auto const extent = extent_of(Handle(H5Aget_space(attribute.get()), H5Sclose), where);
    auto value = room_for(extent.now, type);
    require_read(H5Aread(attribute.get(), type.get(), value.data()) >= 0, where);
    auto const [hash, added] = fixed_.try_emplace(where);
    if (!added) continue;
    add_shape(hash->second, extent.now);
    hash->second.add(value);
  }
}

void Hdf5Digest::add_dataset(Handle const& set, std::string const& path) {
  Handle const type(H5Dget_type(set.get()), H5Tclose);
  Handle const space(H5Dget_space(set.get()), H5Sclose);
  auto const [now, most] = extent_of(space, path);
  bool const grows = !most.empty() && most.front() == H5S_UNLIMITED;
  auto const [hash, added] = (grows ? growing_ : fixed_).try_emplace(path);
  if (!grows) {
    if (!added) return;
    auto value = room_for(now, type);
    require_read(H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) >= 0,
                 path);
    add_shape(hash->second, now);
    hash->second.add(value);
    return;
  }
  Shape rows = now, start(now.size(), 0);
  rows.front() = 1;
  if (added) add_shape(hash->second, rows);
  auto const at_once =
      std::max<hsize_t>(1, block / std::max<std::size_t>(1, room_for(rows, type).size()));
  for (; start.front() < now.front(); start.front() += rows.front()) {
    rows.front() = std::min(at_once, now.front() - start.front());
    auto value = room_for(rows, type);
    Handle const here(H5Screate_simple(static_cast<int>(rows.size()), rows.data(), nullptr),
                      H5Sclose);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, rows.data(), nullptr);
    require_read(
        H5Dread(set.get(), type.get(), here.get(), space.get(), H5P_DEFAULT, value.data()) >= 0,
        path);
    hash->second.add(value);
  }
}

std::map<std::string, std::string> Hdf5Digest::hashes() const {
  std::map<std::string, std::string> all;
  for (auto const* part : {&fixed_, &growing_})
    for (auto const& [path, hash] : *part) all[path] = hash.hex();
  return all;
}

}  // namespace bagnold::io
