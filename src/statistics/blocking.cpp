// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/blocking.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold::statistics {
namespace {

double standard_error(std::span<double const> blocks) {
  double const n = static_cast<double>(blocks.size());
  double mean = 0.0;
  for (double const value : blocks) mean += value / n;
  double squares = 0.0;
  for (double const value : blocks) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (n * (n - 1.0)));
}

}  // namespace

std::vector<BlockLevel> block_levels(std::span<double const> series) {
  std::vector<BlockLevel> levels;
  std::vector<double> blocks(series.begin(), series.end());
  for (std::size_t length = 1; blocks.size() >= 2; length *= 2) {
    levels.push_back({length, blocks.size(), standard_error(blocks)});
    std::size_t const half = blocks.size() / 2;
    for (std::size_t b = 0; b < half; ++b) blocks[b] = (blocks[2 * b] + blocks[2 * b + 1]) / 2.0;
    blocks.resize(half);
  }
  return levels;
}

std::optional<BlockLevel> automatic_level(std::span<BlockLevel const> levels, std::size_t n) {
  for (BlockLevel const& level : levels) {
    double const B = static_cast<double>(level.length);
    double const ratio = level.standard_error / levels.front().standard_error;
    if (B * B * B > 2.0 * static_cast<double>(n) * std::pow(ratio, 4)) return level;
  }
  return std::nullopt;
}

double correlation_time(double standard_error, double first_standard_error) {
  double const ratio = standard_error / first_standard_error;
  return 0.5 * ratio * ratio;
}

std::size_t block_length(double tau, std::size_t n) {
  double const length = std::cbrt(8.0 * static_cast<double>(n) * tau * tau);
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length)));
}

double without_end_effect(double tau_of_blocks, std::size_t length) {
  if (tau_of_blocks <= 0.5) return tau_of_blocks;
  double const B = static_cast<double>(length);
  double const discriminant = 1.0 - 4.0 * tau_of_blocks / B + 1.0 / (B * B);
  return B / 2.0 * (1.0 - std::sqrt(std::max(0.0, discriminant)));
}

}  // namespace bagnold::statistics
