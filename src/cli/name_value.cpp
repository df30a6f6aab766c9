// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/name_value.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "src/config/errors.hpp"

namespace bagnold {

std::map<std::string, std::string> name_values(std::vector<std::string> const& pairs,
                                               std::string const& option) {
  std::map<std::string, std::string> out;
  for (auto const& pair : pairs) {
    auto const equal = pair.find('=');
    if (equal == std::string::npos || equal == 0)
      throw InputError(fmt::format("{} {} (is not NAME=VALUE)", option, pair));
    auto const [place, is_new] = out.try_emplace(pair.substr(0, equal), pair.substr(equal + 1));
    if (!is_new)
      throw InputError(fmt::format("{0} {1}, {0} {2}={3} (is given twice); leave one out", option,
                                   pair, place->first, place->second));
  }
  return out;
}

std::map<std::string, double> name_numbers(std::vector<std::string> const& pairs,
                                           std::string const& option) {
  std::map<std::string, double> out;
  for (auto const& [name, text] : name_values(pairs, option)) {
    auto const* const last = text.data() + text.size();
    auto const [end, error] = std::from_chars(text.data(), last, out[name]);
    if (error != std::errc() || end != last)
      throw InputError(fmt::format("{} {}={} (is not a number)", option, name, text));
  }
  return out;
}

}  // namespace bagnold
