// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace bagnold {

/// Sums over evaluated configurations, in the columns of SumColumns.
struct WindowSums {
  std::vector<double> sums;  ///< [columns]
  double weight = 0.0;       ///< number of evaluations
};

/// Configurations of a run that are evaluated, and their measurement windows: the first
/// configuration of each window, and from there every `every` steps.
struct Sampling {
  std::int64_t window_steps = std::int64_t{1} << 60;
  std::int64_t every = std::int64_t{1} << 60;                         ///< [steps]
  std::int64_t last_step = std::numeric_limits<std::int64_t>::max();  ///< the end of the run
  bool whole = false;           ///< stop before a lookahead that the end of the run would cut short
  std::int64_t first_step = 0;  ///< from which windows are of this length
  std::int64_t first_window = 0;  ///< the window that begins there

  KOKKOS_FUNCTION std::int64_t window(std::int64_t step) const {
    return first_window + (step - first_step) / window_steps;
  }
  KOKKOS_FUNCTION bool sampled(std::int64_t step) const {
    return (step - first_step) % window_steps % every == 0;
  }

  /// First sampled step from `step` on.
  KOKKOS_FUNCTION std::int64_t next(std::int64_t step) const {
    std::int64_t const begin = step - (step - first_step) % window_steps;
    std::int64_t const after = (step - begin + every - 1) / every * every;
    return begin + (after < window_steps ? after : window_steps);
  }
};

class ContactRecord;

/// Measurement windows that are not finished; an engine may be ahead by several.
struct OpenWindows {
  std::int64_t first = 0;  ///< number of the first one
  std::vector<WindowSums> sums;
  std::shared_ptr<ContactRecord> contacts;  ///< where engines report contacts; none: they need not

  WindowSums& of(std::int64_t window) {
    auto const index = static_cast<std::size_t>(window - first);
    if (index >= sums.size()) sums.resize(index + 1);
    return sums[index];
  }

  /// Adds one configuration, or `weight` of them.
  template <class Columns>
  void add(std::int64_t window, Columns const& columns, double weight) {
    WindowSums& to = of(window);
    if (to.sums.size() < std::size(columns)) to.sums.resize(std::size(columns));
    for (std::size_t c = 0; c < std::size(columns); ++c) to.sums[c] += columns[c];
    to.weight += weight;
  }

  /// Removes and returns the first window.
  WindowSums take_first() {
    WindowSums front = std::move(of(first));
    sums.erase(sums.begin());
    ++first;
    return front;
  }
};

}  // namespace bagnold
