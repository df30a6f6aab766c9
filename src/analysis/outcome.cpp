// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "src/analysis/fit/chance.hpp"
#include "src/analysis/random.hpp"
#include "src/config/errors.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::analysis {
namespace {

constexpr double rounding = 1e-12;  ///< relative: what did not change but for this has no spread

double standard_deviation(std::vector<std::vector<double>> const& replicas, std::size_t parameter) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (auto const& one : replicas)
    if (std::isfinite(one[parameter])) sum += one[parameter], count += 1.0;
  if (count < 2.0 || 2.0 * count < static_cast<double>(replicas.size())) return unknown;
  for (auto const& one : replicas)
    if (std::isfinite(one[parameter]))
      squares += (one[parameter] - sum / count) * (one[parameter] - sum / count);
  double const deviation = std::sqrt(squares / (count - 1.0));
  return deviation > rounding * std::abs(sum / count) ? deviation : 0.0;
}

/// Widens the errors of a fit by the scatter about it, see carry_out().
void widen(FitResult& found) {
  if (found.step || found.freedom == 0) return;
  bool const poor = beyond_chance(found);
  if (poor && found.misfit == 0.0)
    found.widened = std::sqrt(found.chi2 / static_cast<double>(found.freedom));
  if (poor || found.alike || !found.weighted)
    found.widened *= statistics::student_factor(found.freedom);
  for (double& error : found.error) error *= found.widened;
}

/// Places features at random between points, see carry_out().
void spread(std::vector<double>& value, std::vector<double> const& grid, Draw const& draw) {
  for (std::size_t k = 0; k < grid.size(); ++k)
    value[k] += std::sqrt(12.0) * grid[k] * random_offset(draw, "place " + std::to_string(k));
}

Outcome carry_out(Task const& task, std::uint32_t number, Request const& request) {
  Outcome out;
  out.labels = task.labels;
  try {
    out.found = task.find(0);
  } catch (InputError const& error) {
    out.failure = error.what();
    return out;
  }
  widen(out.found);
  for (std::size_t k = 0; k < out.found.grid.size(); ++k)
    out.found.error[k] = std::hypot(out.found.error[k], out.found.grid[k]);
  auto const parameters = out.found.value.size();
  for (std::uint32_t replica = 1; replica <= request.resamples; ++replica) try {
      out.replicas.push_back(task.find(replica).value);
      spread(out.replicas.back(), out.found.grid, {request.seed, replica, number});
    } catch (InputError const&) {
      out.replicas.emplace_back(parameters, unknown);
    }
  for (std::size_t k = 0; k < parameters; ++k) {
    double const deviation = standard_deviation(out.replicas, k);
    bool const none_drawn = deviation == 0.0 && out.found.error[k] > 0.0;  // data without an error
    out.bootstrap.push_back(none_drawn ? unknown : deviation);
  }
  return out;
}

}  // namespace

bool beyond_chance(FitResult const& found) {
  return found.weighted && found.freedom != 0 &&
         found.chi2 > chance_limit(static_cast<double>(found.freedom), once_in_1000);
}

std::vector<Outcome> carry_out(std::vector<Task> const& tasks, Request const& request) {
  std::vector<Outcome> out;
  for (auto const& task : tasks)
    out.push_back(carry_out(task, static_cast<std::uint32_t>(out.size()), request));
  if (std::ranges::all_of(out, [](auto const& one) { return !one.failure.empty(); }))
    throw InputError(out.empty() ? "nothing to analyse" : out.front().failure);
  return out;
}

Line sample_line(double low, double high, bool log_x, std::function<double(double)> const& curve) {
  constexpr int places = 200;
  Line line;
  for (int i = 0; i < places; ++i) {
    double const share = i / (places - 1.0);
    line.x.push_back(log_x ? low * std::pow(high / low, share) : low + (high - low) * share);
    line.y.push_back(curve(line.x.back()));
  }
  return line;
}

}  // namespace bagnold::analysis
