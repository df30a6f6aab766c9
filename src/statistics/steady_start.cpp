// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/steady_start.hpp"

#include <limits>
#include <vector>

namespace bagnold::statistics {
namespace {

constexpr std::size_t batch = 5;

std::vector<double> batch_means(std::span<double const> series) {
  std::vector<double> means(series.size() / batch, 0.0);
  for (std::size_t j = 0; j < means.size(); ++j)
    for (std::size_t k = 0; k < batch; ++k) means[j] += series[batch * j + k] / batch;
  return means;
}

}  // namespace

SteadyStart steady_start(std::span<double const> series) {
  SteadyStart const middle{(series.size() + 1) / 2, false};
  auto const means = batch_means(series);
  std::size_t const limit = means.size() / 2;
  if (limit == 0) return middle;
  std::size_t best = limit;
  double least = std::numeric_limits<double>::infinity();
  double mean = 0.0, squares = 0.0,
         count = 0.0;  // of means d .. m - 1, Welford's sums from the end
  for (std::size_t d = means.size(); d-- > 0;) {
    count += 1.0;
    double const off = means[d] - mean;
    mean += off / count;
    squares += off * (means[d] - mean);
    if (double const error2 = squares / (count * count); d <= limit && error2 <= least) {
      least = error2;
      best = d;
    }
  }
  if (best == limit) return middle;
  return {batch * best, true};
}

}  // namespace bagnold::statistics
