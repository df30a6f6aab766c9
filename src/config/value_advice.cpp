// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/value_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <regex>

namespace bagnold {

namespace {

std::string trimmed(std::string_view value) {
  value = value.substr(0, value.find('#'));
  auto const is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!value.empty() && is_blank(value.front())) value.remove_prefix(1);
  while (!value.empty() && is_blank(value.back())) value.remove_suffix(1);
  return std::string(value);
}

std::string without(std::string text, char letter) {
  std::erase(text, letter);
  return text;
}

}  // namespace

std::string value_advice(std::string_view given, Wanted wanted) {
  constexpr std::size_t longest = 60;  // a number has less
  auto const value = trimmed(given);
  if (value.empty() || value.size() > longest) return {};
  std::smatch found;
  auto const is = [&](char const* pattern) {
    return std::regex_match(value, found, std::regex(pattern, std::regex::icase));
  };
  if (wanted == Wanted::choice || wanted == Wanted::anything) {
    if (is("true|yes|on")) return "a choice is true or false, in small letters; write true";
    if (is("false|no|off")) return "a choice is true or false, in small letters; write false";
    if (wanted == Wanted::choice) return {};
  }
  auto const decimal = [&](std::string const& before, std::string const& behind) {
    return wanted == Wanted::whole && behind == "0" ? before : before + "." + behind;
  };
  if (is("[+-]?[1-9][0-9]{0,2}(,[0-9]{3}){2,}"))
    return fmt::format("a number has no commas; write {}", without(value, ','));
  if (is("[+-]?[1-9][0-9]{0,2},[0-9]{3}"))
    return fmt::format("a number has no commas; write {}, or {} with a decimal point",
                       without(value, ','), std::regex_replace(value, std::regex(","), "."));
  if (is("([+-]?[0-9]*),([0-9]+(e[+-]?[0-9]+)?)"))
    return "a number has its decimals behind a point; write " +
           decimal(found[1].length() > 0 ? found[1].str() : "0", found[2].str());
  if (is("([+-]?)(\\.[0-9]+(e[+-]?[0-9]+)?)"))
    return fmt::format("a number begins with a digit; write {}0{}", found[1].str(), found[2].str());
  if (is("([+-]?[0-9]+)\\.(e[+-]?[0-9]+)?"))
    return "behind a point stand digits; write " + decimal(found[1].str(), "0" + found[2].str());
  if (is("([+-]?)0+([0-9].*)"))
    return fmt::format("a number has no zeros in front; write {}{}", found[1].str(),
                       found[2].str());
  if (is("[+-]?[0-9]+( [0-9]+)+"))
    return fmt::format("a number has no blanks; write {}", without(value, ' '));
  if (is("[+-]?[0-9.]+(e[+-]?[0-9]+)? *[*/^].*"))
    return "a value is a number, not a formula; write what it comes to";
  if (is("([+-]?[0-9.]+(e[+-]?[0-9]+)?) *%"))
    return fmt::format("a number has no per cent; write {:g}",
                       std::strtod(found[1].str().c_str(), nullptr) / 100);
  if (is("([+-]?[0-9.]+)d([+-]?[0-9]+)"))
    return fmt::format("an exponent is written with e; write {}e{}", found[1].str(),
                       found[2].str());
  if (is("[+-]?[0-9]+") && std::stold(value) >= 0x1p63L)
    return "an integer is below 2^63 = 9223372036854775808";
  if (is("[+-]?[0-9]+(\\.[0-9]+)?e[+-]?[0-9]+") && std::isinf(std::strtod(value.c_str(), nullptr)))
    return "a number is below 1.8e308";
  return {};
}

}  // namespace bagnold
