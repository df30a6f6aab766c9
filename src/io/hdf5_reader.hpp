// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "src/io/hdf5_checks.hpp"
#include "src/io/hdf5_writer.hpp"

namespace bagnold::io {

/// Reads an HDF5 file that may come from anyone: only what open_dataset admits, with types and
/// shapes compared to what is expected before memory is taken. The file is read from its bytes in
/// memory, so it cannot change under us, and HDF5's file locks (refused on some network disks) play
/// no part. Throws InputError with file, path, reason and remedy; a missing one is named.
class Hdf5Reader {
 public:
  /// `name` is for messages. Hashed::yes: every dataset must carry a true `xxh3`.
  Hdf5Reader(std::string name, std::vector<std::byte> image, Hashed hashed = Hashed::no);

  std::string const& name() const { return open_.name; }
  bool has(std::string const& path) const { return exists(open_, path); }
  Shape shape(std::string const& path) const;

  /// Numbers as doubles, lossless or refused.
  std::vector<double> doubles(std::string const& path, Shape const& expected) const {
    return values<double>(path, expected);
  }
  /// Rows of two: `expected` is the shape without that last axis.
  std::vector<std::array<double, 2>> pairs(std::string const& path, Shape expected) const {
    expected.push_back(2);
    return values<std::array<double, 2>>(path, expected);
  }
  std::vector<std::int64_t> integers(std::string const& path, Shape const& expected) const {
    return values<std::int64_t>(path, expected);
  }
  std::string text(std::string const& path) const;

  /// Texts of one fixed length, one a row; closing zeros are taken off.
  std::vector<std::string> texts(std::string const& path, hsize_t count) const;
  /// Does a dataset hold texts?
  bool holds_text(std::string const& path) const;
  /// Names of the members of a group; at most 10000.
  std::vector<std::string> members(std::string const& group) const;

  /// Attributes of a group, a dataset or the root "/".
  bool has_attribute(std::string const& path, std::string const& name) const;
  double number(std::string const& path, std::string const& name) const;
  std::int64_t integer(std::string const& path, std::string const& name) const;
  std::string words_of(std::string const& path, std::string const& name) const;
  std::vector<std::string> attribute_names(std::string const& path) const;

 private:
  /// Opens the attribute of an object that is there, or refuses, naming it.
  Handle attribute(std::string const& path, std::string const& name) const;
  void read_number(std::string const& path, std::string const& name, hid_t type, void* out) const;
  Handle open_numbers(std::string const& path, Shape const& expected) const;
  void read(std::string const& path, Handle const& dataset, hid_t type,
            std::span<std::byte> out) const;

  template <class Row>
  std::vector<Row> values(std::string const& path, Shape const& expected) const {
    auto const dataset = open_numbers(path, expected);
    std::size_t numbers = 1;
    for (auto const length : expected) numbers *= length;
    constexpr auto width = sizeof(Row) / 8;
    std::vector<Row> out(numbers / width);
    auto const type = std::is_same_v<Row, std::int64_t> ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
    read(path, dataset, type, std::as_writable_bytes(std::span(out)));
    return out;
  }

  Hashed hashed_;
  std::vector<std::byte> image_;  ///< must outlive file_
  Handle file_;
  OpenFile open_;
};

}  // namespace bagnold::io
