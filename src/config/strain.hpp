// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace bagnold {

/// A strain; for a cascade either one, or one for each rate.
struct Strain {
  std::vector<double> each;  ///< [1], or one for each rate

  Strain(double of_all) : each{of_all} {}
  explicit Strain(std::vector<double> list) : each(std::move(list)) {}

  bool is_list() const { return each.size() > 1; }
  double at(std::size_t stage) const { return is_list() ? each.at(stage) : each.front(); }

  /// The strain if there is one.
  operator double() const { return each.front(); }

  friend bool operator==(Strain const& a, Strain const& b) { return a.each == b.each; }
  friend bool operator==(Strain const& a, double b) { return a == Strain(b); }
};

}  // namespace bagnold
