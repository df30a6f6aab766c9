// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bagnold::statistics {

/// Table of windows, one row each: K sums over the evaluations of a window, and their number.
///
/// It holds sums instead of means, so that windows of unequal length add up exactly: the mean of
/// quantity k over windows a .. b is (sum of its sums) / (sum of the weights). Units are those of
/// the quantities.
struct Windows {
  std::size_t columns = 0;     ///< K
  std::vector<double> sums;    ///< [windows][K]
  std::vector<double> weight;  ///< [windows], number of evaluations, > 0

  std::size_t size() const { return weight.size(); }

  /// K sums of one window.
  std::span<double const> row(std::size_t window) const {
    return std::span(sums).subspan(window * columns, columns);
  }

  /// Adds a window. Throws std::invalid_argument unless row has K entries and weight is positive:
  /// a window without evaluations has no mean.
  void push_back(std::span<double const> row, double window_weight);

  /// First `count` windows, or all if there are fewer.
  Windows first(std::size_t count) const;

  /// K means over windows first .. last - 1; NaN if there are none. Throws std::out_of_range beyond
  /// the end.
  std::vector<double> mean(std::size_t first, std::size_t last) const;
};

}  // namespace bagnold::statistics
