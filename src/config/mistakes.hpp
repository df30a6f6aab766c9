// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/config/errors.hpp"

namespace bagnold {

/// What is wrong with one file, to be told in one go.
class Mistakes {
 public:
  /// key: a key or table that is not to be judged further; "": none.
  void add(std::string const& key, std::string const& message);

  /// Runs a check; what it refuses is a mistake of the key.
  template <class Check>
  void collect(std::string const& key, Check const& check) {
    try {
      check();
    } catch (InputError const& error) {
      add(key, error.what());
    }
  }

  /// Is there one of this key, or of the table that it is in?
  bool about(std::string_view key) const;

  /// Throws InputError with a line for each, the first twenty.
  void throw_any() const;

 private:
  std::vector<std::string> keys_, messages_;
};

}  // namespace bagnold
