// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace bagnold {

/// One number, or a list of them: of a cascade the strain of each rate, or one for all.
struct NumberOrList {
  std::vector<double> each;  ///< [1] or more

  NumberOrList(double one) : each{one} {}
  explicit NumberOrList(std::vector<double> list) : each(std::move(list)) {}

  bool is_list() const { return each.size() > 1; }
  double at(std::size_t k) const { return is_list() ? each.at(k) : each.front(); }

  /// The number if there is one.
  operator double() const { return each.front(); }

  friend bool operator==(NumberOrList const& a, NumberOrList const& b) { return a.each == b.each; }
  friend bool operator==(NumberOrList const& a, double b) { return a == NumberOrList(b); }
};

}  // namespace bagnold
