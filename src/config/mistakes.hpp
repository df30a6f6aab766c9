// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/config/errors.hpp"

namespace bagnold {

/// Mistakes of one file, reported together.
class Mistakes {
 public:
  /// key: a key or table that needs no further checks; "": none.
  void add(std::string const& key, std::string const& message);

  /// Runs a check; an InputError is a mistake of the key.
  template <class Check>
  void collect(std::string const& key, Check const& check) {
    try {
      check();
    } catch (InputError const& error) {
      add(key, error.what());
    }
  }

  /// True if there is a mistake of this key, or of its table.
  bool about(std::string_view key) const;

  /// Throws InputError with a line for each, the first twenty.
  void throw_any() const;

 private:
  std::vector<std::string> keys_, messages_;
};

}  // namespace bagnold
