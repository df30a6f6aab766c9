// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_reader.hpp"

#include <algorithm>

#include "src/io/hash.hpp"
#include "src/io/hdf5_memory.hpp"

namespace bagnold::io {
namespace {

constexpr auto again = "the file is damaged: make it again";

H5T_conv_ret_t stop(H5T_conv_except_t, hid_t, hid_t, void*, void*, void*) { return H5T_CONV_ABORT; }

/// Reading stops where a number would change: an integer above 2^53 as a double, 0.5 as an integer.
Handle lossless() {
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_type_conv_cb(transfer.get(), stop, nullptr);
  return transfer;
}

herr_t keep_name(hid_t, char const* name, H5A_info_t const*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

herr_t keep_member(hid_t, char const* name, H5L_info_t const*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

Hdf5Reader::Hdf5Reader(std::string name, std::vector<std::byte> image, Hashed hashed)
    : hashed_(hashed),
      image_(std::move(image)),
      file_(open_in_memory(image_)),
      open_{std::move(name), file_.get(), image_.size()} {
  if (!file_.valid())
    refuse(open_, "/",
           image_.empty() ? "is empty" : "cannot be opened as HDF5 (" + hdf5_reason() + ")",
           "give an HDF5 file, whole and closed by its writer");
}

Shape Hdf5Reader::shape(std::string const& path) const {
  return shape_of(open_, path, open_dataset(open_, path).get());
}

Handle Hdf5Reader::open_numbers(std::string const& path, Shape const& expected) const {
  auto dataset = open_dataset(open_, path);
  check_number(open_, path, Handle(H5Dget_type(dataset.get()), H5Tclose).get());
  auto const found = shape_of(open_, path, dataset.get());
  if (found != expected)
    refuse(open_, path, "has the shape " + words(found) + " (must be " + words(expected) + ")",
           "one row a disk, in the same order in every dataset");
  return dataset;
}

void Hdf5Reader::read(std::string const& path, Handle const& dataset, hid_t type,
                      std::span<std::byte> out) const {
  // an empty vector may have no address, which HDF5 refuses
  if (!out.empty() &&
      H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, lossless().get(), out.data()) < 0)
    refuse(open_, path, "cannot be read without loss (" + hdf5_reason() + ")", again);
  if (hashed_ == Hashed::yes && words_of(path, "xxh3") != xxh3_hex(out))
    refuse(open_, path, "does not have the content that its xxh3 tells", again);
}

std::string Hdf5Reader::text(std::string const& path) const {
  auto const dataset = open_dataset(open_, path);
  Handle type(H5Dget_type(dataset.get()), H5Tclose);
  check_text(open_, path, type.get());
  if (!shape_of(open_, path, dataset.get()).empty())
    refuse(open_, path, "holds several texts", "write one");
  std::string out(H5Tget_size(type.get()), '\0');
  read(path, dataset, type.get(), std::as_writable_bytes(std::span(out)));
  out.pop_back();  // the closing zero
  return out;
}

std::vector<std::string> Hdf5Reader::texts(std::string const& path, hsize_t count) const {
  auto const dataset = open_dataset(open_, path);
  Handle type(H5Dget_type(dataset.get()), H5Tclose);
  check_text(open_, path, type.get());
  if (auto const found = shape_of(open_, path, dataset.get()); found != Shape{count})
    refuse(open_, path, "has the shape " + words(found) + " (must be " + words({count}) + ")",
           "one text a row");
  auto const length = H5Tget_size(type.get());
  std::string all(length * count, '\0');
  read(path, dataset, type.get(), std::as_writable_bytes(std::span(all)));
  std::vector<std::string> out;
  for (hsize_t row = 0; row < count; ++row) {
    auto one = all.substr(row * length, length);
    one.erase(std::min(one.find('\0'), length));
    out.push_back(std::move(one));
  }
  return out;
}

bool Hdf5Reader::holds_text(std::string const& path) const {
  auto const dataset = open_dataset(open_, path);
  return H5Tget_class(Handle(H5Dget_type(dataset.get()), H5Tclose).get()) == H5T_STRING;
}

std::vector<std::string> Hdf5Reader::members(std::string const& group) const {
  constexpr hsize_t most = 10000;
  if (!has(group)) refuse(open_, group, "is missing", "write this group");
  Handle const opened(H5Gopen2(open_.id, group.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t about{};
  if (!opened.valid() || H5Gget_info(opened.get(), &about) < 0)
    refuse(open_, group, "cannot be opened as a group (" + hdf5_reason() + ")", again);
  if (about.nlinks > most)
    refuse(open_, group, "has " + std::to_string(about.nlinks) + " members", "write fewer");
  std::vector<std::string> names;
  if (H5Literate(opened.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_member, &names) < 0)
    refuse(open_, group, "cannot be read (" + hdf5_reason() + ")", again);
  return names;
}

bool Hdf5Reader::has_attribute(std::string const& path, std::string const& name) const {
  if (path != "/" && !has(path)) refuse(open_, path, "is missing", "write this group or dataset");
  auto const there = H5Aexists_by_name(open_.id, path.c_str(), name.c_str(), H5P_DEFAULT);
  if (there < 0) refuse(open_, path + "@" + name, "cannot be read (" + hdf5_reason() + ")", again);
  return there > 0;
}

Handle Hdf5Reader::attribute(std::string const& path, std::string const& name) const {
  auto const where = path + "@" + name;
  if (!has_attribute(path, name)) refuse(open_, where, "is missing", "write this attribute");
  Handle made(H5Aopen_by_name(open_.id, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
              H5Aclose);
  if (!made.valid()) refuse(open_, where, "cannot be opened (" + hdf5_reason() + ")", again);
  Handle space(H5Aget_space(made.get()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) != 1)
    refuse(open_, where, "does not hold one value", "write a scalar");
  return made;
}

void Hdf5Reader::read_number(std::string const& path, std::string const& name, hid_t type,
                             void* out) const {
  auto const where = path + "@" + name;
  auto const made = attribute(path, name);
  Handle stored(H5Aget_type(made.get()), H5Tclose);
  check_number(open_, where, stored.get());
  if (H5Tget_class(type) == H5T_INTEGER && H5Tget_class(stored.get()) != H5T_INTEGER)
    refuse(open_, where, "is not an integer", "write an integer");
  if (H5Aread(made.get(), type, out) < 0)
    refuse(open_, where, "cannot be read (" + hdf5_reason() + ")", again);
}

double Hdf5Reader::number(std::string const& path, std::string const& name) const {
  double value = 0.0;
  read_number(path, name, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t Hdf5Reader::integer(std::string const& path, std::string const& name) const {
  std::int64_t value = 0;
  read_number(path, name, H5T_NATIVE_INT64, &value);
  return value;
}

std::string Hdf5Reader::words_of(std::string const& path, std::string const& name) const {
  auto const made = attribute(path, name);
  Handle type(H5Aget_type(made.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) <= 0)
    refuse(open_, path + "@" + name, "is not a text", "write a text of variable length");
  char* raw = nullptr;
  if (H5Aread(made.get(), type.get(), &raw) < 0)
    refuse(open_, path + "@" + name, "cannot be read (" + hdf5_reason() + ")", again);
  std::string out(raw == nullptr ? "" : raw);
  H5free_memory(raw);
  return out;
}

std::vector<std::string> Hdf5Reader::attribute_names(std::string const& path) const {
  if (path != "/" && !has(path)) refuse(open_, path, "is missing", "write this group or dataset");
  std::vector<std::string> names;
  if (H5Aiterate_by_name(open_.id, path.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_name,
                         &names, H5P_DEFAULT) < 0)
    refuse(open_, path, "has attributes that cannot be read (" + hdf5_reason() + ")", again);
  return names;
}

}  // namespace bagnold::io
