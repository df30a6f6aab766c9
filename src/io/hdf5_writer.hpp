// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/io/hdf5_handle.hpp"

namespace bagnold::io {

/// Value of an attribute: one, or several of one kind, at most 64 KiB of them.
using Value =
    std::variant<std::string, double, std::int64_t, std::vector<double>, std::vector<std::int64_t>>;
using Attributes = std::vector<std::pair<std::string, Value>>;

/// Rows of two as HDF5 wants them.
inline std::span<double const> flat(std::span<std::array<double, 2> const> rows) {
  return rows.empty() ? std::span<double const>() : std::span(rows.front().data(), 2 * rows.size());
}

/// Says if every dataset carries the attribute `xxh3`: the hash of its raw little-endian content.
enum class Hashed { no, yes };

/// Builds an HDF5 file in memory, so that a full disk shows only where the bytes are written
/// (replace_file). The form is the oldest that any HDF5 from 1.8 on reads; no times are kept, so
/// equal content gives equal bytes. Paths are absolute; the groups on the way must be there.
/// Throws FileError (in practice: out of memory).
class Hdf5Writer {
 public:
  explicit Hdf5Writer(Hashed hashed = Hashed::no);
  /// Builds in a new file of create_in_memory().
  explicit Hdf5Writer(Handle file) : hashed_(Hashed::no), file_(std::move(file)) {}

  void group(std::string const& path);
  void dataset(std::string const& path, std::span<double const> values, Shape const& shape,
               Attributes const& attributes = {});
  void dataset(std::string const& path, std::span<std::int64_t const> values, Shape const& shape,
               Attributes const& attributes = {});
  void dataset(std::string const& path, std::span<std::uint8_t const> values, Shape const& shape,
               Attributes const& attributes = {});
  /// One text of any length, UTF-8.
  void text(std::string const& path, std::string const& value, Attributes const& attributes = {});
  /// Texts of any length, UTF-8, as one dataset [n]: each filled up with zeros to the longest.
  void texts(std::string const& path, std::span<std::string const> values);
  void attribute(std::string const& path, std::string const& name, Value const& value);
  /// An attribute of as many letters as the text has, for readers that want these.
  void letters(std::string const& path, std::string const& name, std::string const& value);

  /// Dataset of another file.
  struct Source {
    std::string file, path;
    Shape shape;
  };
  /// The values of the source in the same order, in another shape; NaN (of integers 0) where its
  /// file is not there. The file must allow virtual datasets.
  void virtual_dataset(std::string const& path, hid_t type, Shape const& shape,
                       Source const& source);

  /// Names axes by dimension scales (H5DS of HDF5, whose own library is not needed): axis k of each
  /// dataset has the scale k, a dataset of as many numbers as that axis is long.
  void scale_axes(std::vector<std::string> const& scales, std::vector<std::string> const& datasets);

  /// The file as it would be on the disk: HDF5's own memory, while this lives and nothing is added.
  std::span<std::byte const> content() const;

 private:
  void write(std::string const& path, hid_t type, Handle space, std::span<std::byte const> raw,
             Attributes const& attributes);

  Hashed hashed_;
  Handle file_;
};

}  // namespace bagnold::io
