// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/toml_table.hpp"

#include <fmt/format.h>

#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/toml_text.hpp"

namespace bagnold {

toml::table parse_toml(std::string_view text, std::string const& origin) {
  refuse_strange_bytes(text, origin);
  try {
    return toml::parse(text, origin);
  } catch (toml::parse_error const& error) {
    auto const at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: {}", origin, at.line, at.column, error.description()));
  }
}

std::string describe(toml::node const& node) {
  if (auto const* text = node.as_string()) return fmt::format("\"{}\"", text->get());
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  std::ostringstream out;
  node.visit([&](auto const& value) { out << value; });
  return out.str();
}

}  // namespace bagnold
