// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bagnold::sweep {

/// A value of a varied key in tables: a number, or the text of anything else.
using Value = std::variant<double, std::string>;

/// One list of the table [sweep]: a key of the scene and its values.
struct VariedKey {
  struct Given {
    Value value;
    std::string toml;   ///< as TOML
    std::string place;  ///< "file:line:column"
  };
  std::string name;  ///< "table.key"
  std::string place;
  std::vector<Given> values;
};

/// Table [sweep] of a file.
struct SweepTable {
  std::vector<VariedKey> zip;   ///< lists of one length, walked together: one row each
  std::vector<VariedKey> grid;  ///< every combination, for every row of `zip`; the last key fastest
  std::string chain;  ///< key along which a point starts from the state of the one before; "": none

  /// True if the chain runs along the rows of zip.
  bool chained_along_zip() const {
    return std::ranges::any_of(zip, [this](VariedKey const& key) { return key.name == chain; });
  }
};

/// True if the text has a table [sweep]. Throws InputError if it is not TOML.
bool is_sweep(std::string_view text, std::string const& origin);

/// Reads the table [sweep] of a file, keys in the order of the file. Throws InputError with line
/// and column for: no table, unknown entries, lists that are missing, empty or of unequal lengths,
/// a key in two lists, a chain that is not a varied key. Whether keys are keys of the scene is not
/// checked here.
SweepTable read_sweep_table(std::string_view text, std::string const& origin);

/// Text without its table [sweep], rewritten as TOML.
std::string without_sweep(std::string_view text, std::string const& origin);

/// Shortest text that reads back to the same number; other values as they are.
std::string text_of(Value const& value);

}  // namespace bagnold::sweep
