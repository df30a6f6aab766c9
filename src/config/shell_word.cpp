// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace bagnold {

std::string shell_word(std::string const& word) {
  static constexpr std::string_view plain_marks = "_./=+-,:";
  auto const plain = [](unsigned char c) {
    return std::isalnum(c) || plain_marks.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string quoted = "'";
  for (char const c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace bagnold
