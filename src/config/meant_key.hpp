// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// Suggestion for an unknown key.
struct MeantKey {
  std::string key;  ///< "" where none is like it
  std::string
      remark;  ///< appended to the error: "; did you mean KEY?", or why the key does not exist
};

/// Suggestion for a key, with its table or without, among the `keys` of a scene. It is found by
/// names in other programs and papers (dt, N, phi, gammadot, steps, friction, ...), or by its
/// letters.
MeantKey meant_key(std::string const& wrong, std::vector<std::string> const& keys);

/// Suggestion for a key among all known keys.
MeantKey meant_key(std::string const& wrong);

/// Suggestion for a table among `tables`.
MeantKey meant_table(std::string const& wrong, std::vector<std::string> const& tables);

}  // namespace bagnold
