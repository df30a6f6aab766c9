// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/shown.hpp"
#include "src/config/toml_text.hpp"

namespace bagnold {

namespace {

std::string_view line_of(std::string_view text, std::size_t line) {
  for (; line > 1; --line) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  return text.substr(0, text.find('\n'));
}

/// What follows the first equals sign of a line.
std::string_view value_in(std::string_view line) {
  auto const equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  auto const value = line.find_first_not_of(" \t", equals + 1);
  return value == std::string_view::npos ? std::string_view{} : line.substr(value);
}

/// A word where a value should be was meant as text; so was what a quote begins and none ends.
std::string quotes_advice(std::string_view text, toml::source_position const& at) {
  auto const line = line_of(text, at.line), value = value_in(line);
  auto const begins_word = [](std::string_view from) {
    return !from.empty() && (std::isalpha(static_cast<unsigned char>(from[0])) != 0 ||
                             std::string_view("/.~_").find(from[0]) != std::string_view::npos);
  };
  if (value.starts_with('"') || value.starts_with('\''))
    return "; texts stand in quotes, one at each end";
  bool const in_list = value.starts_with('[') || value.starts_with('{') || value.empty();
  bool const word =
      begins_word(in_list ? line.substr(std::min<std::size_t>(line.size(), at.column - 1)) : value);
  return word ? "; texts stand in quotes" : "";
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string const& origin) {
  refuse_strange_bytes(text, origin);
  try {
    return toml::parse(text, origin);
  } catch (toml::parse_error const& error) {
    auto const at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: {}{}", origin, at.line, at.column,
                                 shown(error.description()), quotes_advice(text, at)));
  }
}

std::string describe(toml::node const& node) {
  if (auto const* text = node.as_string()) return fmt::format("\"{}\"", shown(text->get()));
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  std::ostringstream out;
  node.visit([&](auto const& value) { out << value; });
  return out.str();
}

}  // namespace bagnold
