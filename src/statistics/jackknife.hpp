// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "src/statistics/windows.hpp"

namespace bagnold::statistics {

/// A quantity as a function of the K averages of a table of windows, for instance sigma/p.
using Function = std::function<double(std::span<double const>)>;

/// Change of f of the averages as windows are left out. Windows before `first` do not count; n
/// windows do, with weights m_w and the sum M. Keeps references: both arguments must outlive it.
class Jackknife {
 public:
  Jackknife(Windows const& windows, std::size_t first, Function const& f);

  /// f(all), NaN if undefined.
  double value() const { return value_; }

  /// (n / M) (M - m_w) (f - f_{-w}) for each window w, in the unit of f. Quenouille's
  /// pseudo-values less f; for equal weights (n - 1) (f - f_{-w}). To first order f fluctuates like
  /// the mean of this series, so that its correlations are those of f.
  std::vector<double> deviations();

  /// Standard error of f from g blocks of `length` windows, the rest being joined to the last, were
  /// the blocks independent. With h_b = M / m_b and p_b = h_b f - (h_b - 1) f_{-b},
  ///
  ///     error^2 = (1/g) sum_b (p_b - p)^2 / (h_b - 1),   p = sum_b p_b / h_b
  ///
  /// (Busing, Meijer and van der Leeden, Stat. Comput. 9, 3 (1999)); blocks of one size give the
  /// usual (g-1)/g sum_b (f_{-b} - mean)^2. Wants 2 blocks at least.
  double error(std::size_t length);

 private:
  /// Adds up windows begin .. end - 1 into `sums`, and returns their weight.
  double add(std::size_t begin, std::size_t end, std::vector<double>& sums) const;

  /// Weight of windows begin .. end - 1, and f of the averages over all the others.
  std::pair<double, double> without(std::size_t begin, std::size_t end);

  Windows const& windows_;
  Function const& f_;
  std::size_t first_;
  std::vector<double> total_;  ///< [K]
  double total_weight_;        ///< M
  std::vector<double> averages_;
  double value_;
};

}  // namespace bagnold::statistics
