// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "src/io/hash.hpp"
#include "src/io/hdf5_handle.hpp"

namespace bagnold::io {

/// Content of HDF5 files, as a reader sees it: a hash of every attribute and every dataset. Of
/// several files: datasets that grow (of unlimited length) count as one behind the other, all else
/// as the first file has it.
class Hdf5Digest {
 public:
  /// All in an open file, read row by row. Throws FileError.
  void add(Handle const& file);

  /// By path, attributes as PATH@NAME, in 16 hexadecimal digits.
  std::map<std::string, std::string> hashes() const;

 private:
  void add_object(Handle const& object, std::string const& path);
  void add_attributes(Handle const& object, std::string const& path);
  void add_dataset(Handle const& set, std::string const& path);

  std::map<std::string, Xxh3> fixed_, growing_;
};

}  // namespace bagnold::io
