// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "src/statistics/blocking.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::statistics {
namespace {

/// True if a series with this standard error, as of independent values, is only rounding of f(all)
/// - f(all but w): a few epsilon |f|, which deviations() magnifies n times.
bool only_rounding(double standard_error, std::size_t n, double f) {
  double const count = static_cast<double>(n);
  double const rounding = 16.0 * std::numeric_limits<double>::epsilon() * count * std::abs(f);
  return standard_error * std::sqrt(count) <= rounding;
}

std::string counted(long count, std::string const& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Factor by which a run of n windows must be longer for an error that is not rough, by this
/// correlation time. 64 tau are enough; half as much again is added, since short series show too
/// small a tau.
long times_longer(std::size_t n, double tau) {
  return std::max(2l, std::lround(std::ceil(96.0 * tau / static_cast<double>(n))));
}

/// Adds the reason why n windows are too few, by the largest correlation time that they can show.
void say_too_short(Estimate& result, std::vector<BlockLevel> const& levels) {
  double tau = 0.5;
  for (BlockLevel const& level : levels) {
    if (level.blocks < fewest_rough_blocks) break;
    double const se_1 = levels.front().standard_error;
    tau = std::max(tau, correlation_time(level.standard_error, se_1));
  }
  result.independent = static_cast<double>(result.samples) / (2.0 * tau);
  long const independent = std::max(1l, std::lround(result.independent));
  result.remark = "worth about " + counted(independent, "independent window") + ": run about " +
                  std::to_string(times_longer(result.samples, tau)) + " times longer for an error";
}

/// Widens the error of too few blocks so that mean +- 2 errors is an interval of 95%.
void make_rough(Estimate& result) {
  result.rough = true;
  *result.error *= student_factor(result.blocks - 1);
  result.remark = "rough, from " + counted(static_cast<long>(result.blocks), "block") +
                  ": run about " +
                  std::to_string(times_longer(result.samples, *result.correlation)) +
                  " times longer for a better error";
}

/// Adds the error of a finite mean, or the remark.
void add_error(Estimate& result, Jackknife& jackknife) {
  std::size_t const n = result.samples;
  if (n < fewest_rough_blocks) return say_too_short(result, {});
  std::vector<double> const series = jackknife.deviations();
  if (!std::ranges::all_of(series, [](double value) { return std::isfinite(value); })) {
    result.remark = "undefined without one of the windows: run longer for an error";
    return;
  }
  std::vector<BlockLevel> const levels = block_levels(series);
  double const se_1 = levels.front().standard_error;
  if (only_rounding(se_1, n, *result.mean)) {
    if (n < fewest_blocks) return say_too_short(result, {});
    result.error = 0.0;
    result.blocks = n;
    result.independent = static_cast<double>(n);
    return;
  }
  auto const level = automatic_level(levels, n);
  bool const enough = level && level->blocks >= fewest_rough_blocks;
  std::size_t const length =
      enough ? block_length(correlation_time(level->standard_error, se_1), n) : n;
  if (n / length < fewest_rough_blocks) return say_too_short(result, levels);
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
  if (result.blocks < fewest_blocks) make_rough(result);
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
