// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "src/statistics/windows.hpp"

namespace bagnold::statistics {

/// First-order autoregressive series, x_{t+1} = rho x_t + (1 - rho^2)^(1/2) g_t, g_t normal: mean
/// 0, variance 1, correlation rho^|t|.
struct Autoregressive {
  double rho;
  std::mt19937_64 random;
  std::normal_distribution<double> normal{};
  double value = 0.0;

  Autoregressive(double correlation, std::uint64_t seed) : rho(correlation), random(seed) {
    value = normal(random);
  }

  double next() {
    double const now = value;
    value = rho * value + std::sqrt(1.0 - rho * rho) * normal(random);
    return now;
  }

  /// tau_int = 1/2 + sum_{t >= 1} rho^t.
  double correlation_time() const { return (1.0 + rho) / (2.0 * (1.0 - rho)); }

  /// Standard deviation of the mean of n values: var = (1/n) [2 tau - 2 rho (1 - rho^n) /
  /// (n (1 - rho)^2)], from summing rho^|s - t| over both.
  double error_of_mean(std::size_t n) const {
    double const count = static_cast<double>(n);
    double const ends = 2.0 * rho * (1.0 - std::pow(rho, count)) / (count * std::pow(1 - rho, 2));
    return std::sqrt((2.0 * correlation_time() - ends) / count);
  }
};

/// One window of weight 1 for each value.
inline Windows windows_of(std::vector<double> const& values) {
  Windows windows{1, {}, {}};
  for (double const& value : values) windows.push_back({&value, 1}, 1.0);
  return windows;
}

inline double identity(std::span<double const> averages) { return averages[0]; }

}  // namespace bagnold::statistics
