// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/shown.hpp"
#include "src/config/toml_text.hpp"
#include "src/config/value_advice.hpp"

namespace bagnold {

namespace {

std::string_view line_of(std::string_view text, std::size_t line) {
  for (; line > 1; --line) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  return text.substr(0, text.find('\n'));
}

/// Text behind the first equals sign of a line.
std::string_view value_in(std::string_view line) {
  auto const equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  auto const value = line.find_first_not_of(" \t", equals + 1);
  return value == std::string_view::npos ? std::string_view{} : line.substr(value);
}

/// "strain = 40,0 (a number has its decimals behind a point; write 40.0)"; "" where nothing is
/// known of the value.
std::string own_words(std::string_view text, toml::source_position const& at) {
  auto const line = line_of(text, at.line), value = value_in(line);
  auto const advice = value_advice(value);
  if (advice.empty()) return {};
  auto const key = line.substr(0, line.find_last_not_of(" \t", line.find('=') - 1) + 1);
  return fmt::format("{} = {} ({})", shown(key), shown(value.substr(0, value.find('#'))), advice);
}

/// Advice on quotes: a word in place of a value was meant as text, and so was an opening quote
/// without a closing one.
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
    if (auto const words = own_words(text, at); !words.empty())
      throw InputError(fmt::format("{}:{}:{}: {}", origin, at.line, at.column, words));
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
