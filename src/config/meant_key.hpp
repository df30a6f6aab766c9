// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// What somebody who wrote a key that is not there may have meant.
struct MeantKey {
  std::string key;  ///< "" where none is like it
  std::string
      remark;  ///< to stand behind the complaint: "; did you mean KEY?", or why there is none
};

/// Of a key, with its table or without, among the `keys` of a scene: by what other programs and
/// papers call it (dt, N, phi, gammadot, steps, friction, ...), or by its letters.
MeantKey meant_key(std::string const& wrong, std::vector<std::string> const& keys);

/// The same among all keys that there are.
MeantKey meant_key(std::string const& wrong);

/// Likewise of a table, among the tables.
MeantKey meant_table(std::string const& wrong, std::vector<std::string> const& tables);

}  // namespace bagnold
