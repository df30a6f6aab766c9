// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

#include "src/config/errors.hpp"
#include "src/io/hash.hpp"
#include "src/io/hdf5_memory.hpp"

namespace bagnold::io {
namespace {

static_assert(std::endian::native == std::endian::little, "raw content is hashed as it lies");

void require(bool good, std::string const& path) {
  if (!good)
    throw FileError(fmt::format("cannot build {} of an HDF5 file: {}", path, hdf5_reason()));
}

Handle plain_space(std::string const& path, std::size_t count, Shape const& shape) {
  hsize_t product = 1;
  for (auto const length : shape) product *= length;
  if (product != count)
    throw std::logic_error(fmt::format("{}: {} values for a shape of {}", path, count, product));
  Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  require(space.valid(), path);
  return space;
}

/// Fixed length, one byte more than the text so that none is empty.
Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

void put_attribute(Handle const& file, std::string const& path, std::string const& name, hid_t type,
                   void const* data, Handle const& space) {
  auto const where = path + "@" + name;
  Handle made(H5Acreate_by_name(file.get(), path.c_str(), name.c_str(), type, space.get(),
                                H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              H5Aclose);
  require(made.valid(), where);
  require(H5Awrite(made.get(), type, data) >= 0, where);
}

}  // namespace

Hdf5Writer::Hdf5Writer(Hashed hashed) : hashed_(hashed), file_(create_in_memory()) {}

void Hdf5Writer::group(std::string const& path) {
  auto const creation = without_times(H5P_GROUP_CREATE);
  Handle made(H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
              H5Gclose);
  require(made.valid(), path);
}

void Hdf5Writer::write(std::string const& path, hid_t type, Handle space,
                       std::span<std::byte const> raw, Attributes const& attributes) {
  auto const creation = without_times(H5P_DATASET_CREATE);
  Handle set(H5Dcreate2(file_.get(), path.c_str(), type, space.get(), H5P_DEFAULT, creation.get(),
                        H5P_DEFAULT),
             H5Dclose);
  require(set.valid(), path);
  // an empty vector may have no address, which HDF5 refuses
  if (!raw.empty())
    require(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) >= 0, path);
  require(set.close(), path);
  for (auto const& [name, value] : attributes) attribute(path, name, value);
  if (hashed_ == Hashed::yes) attribute(path, "xxh3", xxh3_hex(raw));
}

void Hdf5Writer::dataset(std::string const& path, std::span<double const> values,
                         Shape const& shape, Attributes const& attributes) {
  write(path, H5T_IEEE_F64LE, plain_space(path, values.size(), shape), std::as_bytes(values),
        attributes);
}

void Hdf5Writer::dataset(std::string const& path, std::span<std::int64_t const> values,
                         Shape const& shape, Attributes const& attributes) {
  write(path, H5T_STD_I64LE, plain_space(path, values.size(), shape), std::as_bytes(values),
        attributes);
}

void Hdf5Writer::dataset(std::string const& path, std::span<std::uint8_t const> values,
                         Shape const& shape, Attributes const& attributes) {
  write(path, H5T_STD_U8LE, plain_space(path, values.size(), shape), std::as_bytes(values),
        attributes);
}

void Hdf5Writer::text(std::string const& path, std::string const& value,
                      Attributes const& attributes) {
  auto const type = text_type(value.size() + 1);
  // c_str() has the closing zero that the type counts
  write(path, type.get(), Handle(H5Screate(H5S_SCALAR), H5Sclose),
        std::as_bytes(std::span(value.c_str(), value.size() + 1)), attributes);
}

void Hdf5Writer::texts(std::string const& path, std::span<std::string const> values) {
  std::size_t longest = 0;
  for (auto const& value : values) longest = std::max(longest, value.size());
  std::string filled;
  for (auto const& value : values) filled += value + std::string(longest + 1 - value.size(), '\0');
  auto const type = text_type(longest + 1);
  write(path, type.get(), plain_space(path, values.size(), {values.size()}),
        std::as_bytes(std::span(filled)), {});
}

void Hdf5Writer::attribute(std::string const& path, std::string const& name, Value const& value) {
  auto const put = [&](hid_t type, void const* data, Handle const& space) {
    put_attribute(file_, path, name, type, data, space);
  };
  auto const scalar = [] { return Handle(H5Screate(H5S_SCALAR), H5Sclose); };
  auto const row = [&](std::size_t length) {
    return plain_space(path + "@" + name, length, {length});
  };
  if (auto const* number = std::get_if<double>(&value)) {
    put(H5T_IEEE_F64LE, number, scalar());
  } else if (auto const* integer = std::get_if<std::int64_t>(&value)) {
    put(H5T_STD_I64LE, integer, scalar());
  } else if (auto const* numbers = std::get_if<std::vector<double>>(&value)) {
    put(H5T_IEEE_F64LE, numbers->data(), row(numbers->size()));
  } else if (auto const* integers = std::get_if<std::vector<std::int64_t>>(&value)) {
    put(H5T_STD_I64LE, integers->data(), row(integers->size()));
  } else {
    // variable length: h5py then gives str, not bytes
    auto const type = text_type(H5T_VARIABLE);
    char const* const text = std::get<std::string>(value).c_str();
    put(type.get(), &text, scalar());
  }
}

void Hdf5Writer::letters(std::string const& path, std::string const& name,
                         std::string const& value) {
  Handle const type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type.get(), value.size());
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  put_attribute(file_, path, name, type.get(), value.data(), space);
}

void Hdf5Writer::virtual_dataset(std::string const& path, hid_t type, Shape const& shape,
                                 Source const& source) {
  auto const space_of = [&](Shape const& of) {
    Handle space(H5Screate_simple(static_cast<int>(of.size()), of.data(), nullptr), H5Sclose);
    require(space.valid(), path);
    return space;
  };
  auto const creation = without_times(H5P_DATASET_CREATE);
  double const none = std::numeric_limits<double>::quiet_NaN();
  if (H5Tget_class(type) == H5T_FLOAT) H5Pset_fill_value(creation.get(), H5T_NATIVE_DOUBLE, &none);
  auto const from = space_of(source.shape), to = space_of(shape);
  require(H5Pset_virtual(creation.get(), to.get(), source.file.c_str(), source.path.c_str(),
                         from.get()) >= 0,
          path);
  Handle made(H5Dcreate2(file_.get(), path.c_str(), type, to.get(), H5P_DEFAULT, creation.get(),
                         H5P_DEFAULT),
              H5Dclose);
  require(made.valid() && made.close(), path);
}

void Hdf5Writer::scale_axes(std::vector<std::string> const& scales,
                            std::vector<std::string> const& datasets) {
  struct User {  // a dataset with this scale, and along which of its axes
    hobj_ref_t dataset;
    int axis;
  };
  Handle const scalar(H5Screate(H5S_SCALAR), H5Sclose);
  Handle const list(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  Handle const user(H5Tcreate(H5T_COMPOUND, sizeof(User)), H5Tclose);
  H5Tinsert(user.get(), "dataset", HOFFSET(User, dataset), H5T_STD_REF_OBJ);
  H5Tinsert(user.get(), "dimension", HOFFSET(User, axis), H5T_NATIVE_INT);
  auto const reference = [&](std::string const& path) {
    hobj_ref_t made{};
    require(H5Rcreate(&made, file_.get(), path.c_str(), H5R_OBJECT, -1) >= 0, path);
    return made;
  };
  auto const word = [&](std::string const& path, char const* name, std::string const& value) {
    Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), value.size() + 1);
    put_attribute(file_, path, name, type.get(), value.c_str(), scalar);
  };
  std::vector<hobj_ref_t> axes;
  for (auto const& path : scales) axes.push_back(reference(path));
  for (auto const& path : datasets) {
    std::vector<hvl_t> names;
    for (auto& axis : axes) names.push_back({1, &axis});
    put_attribute(file_, path, "DIMENSION_LIST", list.get(), names.data(),
                  plain_space(path, names.size(), {names.size()}));
  }
  for (std::size_t k = 0; k < scales.size(); ++k) {
    std::vector<User> users;
    for (auto const& path : datasets) users.push_back({reference(path), static_cast<int>(k)});
    word(scales[k], "CLASS", "DIMENSION_SCALE");
    word(scales[k], "NAME", scales[k].substr(scales[k].rfind('/') + 1));
    if (users.empty()) continue;
    put_attribute(file_, scales[k], "REFERENCE_LIST", user.get(), users.data(),
                  plain_space(scales[k], users.size(), {users.size()}));
  }
}

std::span<std::byte const> Hdf5Writer::content() const { return content_of(file_); }

}  // namespace bagnold::io
