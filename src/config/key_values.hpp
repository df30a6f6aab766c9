// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bagnold {

/// Value of a key of a scene: a number or a text, of lists too; neither where it is a word in the
/// place of a number, or a table.
struct KeyValue {
  std::string name;  ///< "disks.elasticity"
  std::optional<double> number;
  std::optional<std::string> text;
};

/// Values of all keys of a scene's text, for those who need not know the scene. Throws InputError
/// as parse_scene does.
std::vector<KeyValue> key_values(std::string const& text, std::string const& origin,
                                 std::filesystem::path const& folder);

}  // namespace bagnold
