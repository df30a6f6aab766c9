// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "src/statistics/blocking.hpp"

namespace bagnold::statistics {
namespace {

/// Fewest blocks from which a first correlation time is taken.
constexpr std::size_t fewest_for_level = 4;

/// Whether a series of this standard error, as of independent values, is nothing but the rounding
/// of f(all) - f(all but w), a few epsilon |f|, that deviations() blows up n times.
bool only_rounding(double standard_error, std::size_t n, double f) {
  double const count = static_cast<double>(n);
  double const rounding = 16.0 * std::numeric_limits<double>::epsilon() * count * std::abs(f);
  return standard_error * std::sqrt(count) <= rounding;
}

/// Why n windows are too few, going by the largest correlation time that they let show.
void say_too_short(Estimate& result, std::vector<BlockLevel> const& levels) {
  double tau = 0.5;
  for (BlockLevel const& level : levels) {
    if (level.blocks < fewest_for_level) break;
    double const se_1 = levels.front().standard_error;
    tau = std::max(tau, correlation_time(level.standard_error, se_1));
  }
  double const count = static_cast<double>(result.samples);
  result.independent = count / (2.0 * tau);
  // Enough is 64 tau; half as much again, since short series show too small a tau.
  long const times = std::max(2l, std::lround(std::ceil(96.0 * tau / count)));
  long const independent = std::max(1l, std::lround(result.independent));
  result.remark = "worth about " + std::to_string(independent) +
         (independent == 1 ? " independent window" : " independent windows") + ": run about " +
         std::to_string(times) + " times longer for an error";
}

/// Fills in the error of a finite mean, or the remark.
void add_error(Estimate& result, Jackknife& jackknife) {
  std::size_t const n = result.samples;
  if (n < fewest_blocks) return say_too_short(result, {});
  std::vector<double> const series = jackknife.deviations();
  if (!std::ranges::all_of(series, [](double value) { return std::isfinite(value); })) {
    result.remark = "undefined without one of the windows: run longer for an error";
    return;
  }
  std::vector<BlockLevel> const levels = block_levels(series);
  double const se_1 = levels.front().standard_error;
  if (only_rounding(se_1, n, *result.mean)) {
    result.error = 0.0;
    result.blocks = n;
    result.independent = static_cast<double>(n);
    return;
  }
  auto const level = automatic_level(levels, n);
  bool const enough = level && level->blocks >= fewest_for_level;
  std::size_t const length =
      enough ? block_length(correlation_time(level->standard_error, se_1), n) : n;
  if (n / length < fewest_blocks) return say_too_short(result, levels);
  double const error = jackknife.error(length);
  if (!std::isfinite(error)) {
    result.remark = "undefined without one of the blocks: run longer for an error";
    return;
  }
  double const tau_of_blocks = correlation_time(error, se_1);
  double const tau = without_end_effect(tau_of_blocks, length);
  result.error = se_1 * std::sqrt(2.0 * tau);
  result.correlation = tau;
  result.blocks = n / length;
  result.independent = static_cast<double>(n) / (2.0 * tau);
}

}  // namespace

Estimate estimate(Windows const& windows, std::size_t first, Function const& f) {
  Estimate result;
  if (first >= windows.size()) {
    result.remark = "no window was measured: run longer";
    return result;
  }
  result.samples = windows.size() - first;
  Jackknife jackknife(windows, first, f);
  if (!std::isfinite(jackknife.value())) {
    result.remark = "undefined: the averages give no finite value";
    return result;
  }
  result.mean = jackknife.value();
  add_error(result, jackknife);
  return result;
}

}  // namespace bagnold::statistics
