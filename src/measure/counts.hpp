// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "src/statistics/tables.hpp"

namespace bagnold {

/// Counts of values between given edges.
class Counts {
 public:
  /// edges: [n + 1], ascending.
  explicit Counts(std::vector<double> edges);

  /// Counts a value. NaN is ignored; a value beyond the edges counts in the total only.
  void add(double value);

  /// Adds counts with the same edges.
  void add(Counts const& other);

  /// density[b] = count[b] / (total width[b]).
  statistics::Histogram histogram(std::string name, std::string unit,
                                  std::string description) const;

  /// [n] counts and the total; and the inverse.
  std::vector<double> numbers() const;
  void restore(std::vector<double> const& numbers);

 private:
  std::vector<double> edges_;
  std::vector<double> count_;
  double total_ = 0.0;
};

/// n equal bins from first to last.
std::vector<double> even_edges(double first, double last, std::size_t n);

/// 2 n bins about a centre, edge k at centre + sinh(u), u uniform in -reach .. reach: narrow where
/// values are dense, wide in long tails, without a guess of their width.
std::vector<double> sinh_edges(double centre, double reach, std::size_t n);

}  // namespace bagnold
