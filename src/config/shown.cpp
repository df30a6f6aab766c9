// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/shown.hpp"

#include <fmt/format.h>

namespace bagnold {

namespace {

constexpr std::size_t most_bytes = 200;

/// True if a byte continues a character of UTF-8.
bool inside_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

std::string shown(std::string_view text) {
  std::size_t end = text.size();
  if (end > most_bytes)
    for (end = most_bytes; end > 0 && inside_character(text[end]);) --end;
  std::string out;
  for (char const c : text.substr(0, end))
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  return end < text.size() ? out + "..." : out;
}

}  // namespace bagnold
