// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace bagnold {

/// A number, or the name of a rule that gives one.
struct NumberOrWord {
  std::optional<double> number;
  std::string word;  ///< empty where there is a number

  NumberOrWord(double given) : number(given) {}
  NumberOrWord(char const* rule) : word(rule) {}

  friend bool operator==(NumberOrWord const&, NumberOrWord const&) = default;
};

}  // namespace bagnold
