// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/windows.hpp"

#include <algorithm>
#include <stdexcept>

namespace bagnold::statistics {

void Windows::push_back(std::span<double const> row, double window_weight) {
  if (row.size() != columns) throw std::invalid_argument("a window needs one sum per column");
  if (!(window_weight > 0.0))
    throw std::invalid_argument("the weight of a window must be positive");
  sums.insert(sums.end(), row.begin(), row.end());
  weight.push_back(window_weight);
}

Windows Windows::first(std::size_t count) const {
  auto const kept = static_cast<std::ptrdiff_t>(std::min(count, size()));
  return {columns,
          {sums.begin(), sums.begin() + kept * static_cast<std::ptrdiff_t>(columns)},
          {weight.begin(), weight.begin() + kept}};
}

std::vector<double> Windows::mean(std::size_t first, std::size_t last) const {
  if (last > size()) throw std::out_of_range("mean over windows beyond the last");
  std::vector<double> total(columns, 0.0);
  double total_weight = 0.0;
  for (std::size_t window = first; window < last; ++window) {
    for (std::size_t k = 0; k < columns; ++k) total[k] += sums[window * columns + k];
    total_weight += weight[window];
  }
  for (double& value : total) value /= total_weight;
  return total;
}

}  // namespace bagnold::statistics
