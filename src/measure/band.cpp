// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/band.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace bagnold {
namespace {

/// Mean over an eighth of the period, beginning at bin b.
double mean_from(std::span<double const> profile, std::size_t b) {
  std::size_t const width = std::max<std::size_t>(1, profile.size() / 8);
  double sum = 0;
  for (std::size_t k = 0; k < width; ++k) sum += profile[(b + k) % profile.size()];
  return sum / static_cast<double>(width);
}

}  // namespace

double band_position(std::span<double const> excess, double length) {
  using namespace std::complex_literals;
  constexpr double turn = 2 * std::numbers::pi;
  double const n = static_cast<double>(excess.size());
  std::complex<double> mode = 0;
  for (std::size_t b = 0; b < excess.size(); ++b)
    mode += excess[b] * std::polar(1.0, -turn * (static_cast<double>(b) + 0.5) / n);
  double const turns = -std::arg(1i * mode) / turn;
  return length * (turns - std::floor(turns));
}

double share_below(std::span<double const> profile, double level) {
  if (std::ranges::any_of(profile, [](double value) { return std::isnan(value); }))
    return std::numeric_limits<double>::quiet_NaN();
  double share = 0;
  for (std::size_t b = 0; b < profile.size(); ++b) {
    double const low = std::min(profile[b], profile[(b + 1) % profile.size()]) - level;
    double const high = std::max(profile[b], profile[(b + 1) % profile.size()]) - level;
    if (!(low < 0)) continue;
    share += high <= 0 ? 1.0 : low / (low - high);
  }
  return share / static_cast<double>(profile.size());
}

double in_fastest_band(std::span<double const> rate, std::span<double const> profile) {
  double most = -std::numeric_limits<double>::infinity();
  std::size_t fastest = 0;
  for (std::size_t b = 0; b < rate.size(); ++b) {
    if (std::isnan(rate[b] + profile[b])) return std::numeric_limits<double>::quiet_NaN();
    if (double const mean = mean_from(rate, b); mean > most) most = mean, fastest = b;
  }
  return mean_from(profile, fastest);
}

}  // namespace bagnold
