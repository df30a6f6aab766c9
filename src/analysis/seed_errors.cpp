// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/seed_errors.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/curves.hpp"
#include "src/analysis/fit/chance.hpp"
#include "src/analysis/fit/fit.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::analysis {
namespace {

constexpr double least_freedom = 8.0;  ///< a scatter is then known to a quarter
constexpr double known = 200.0;        ///< of so many Student's factor is 1.01

struct Scatter {
  double chi2, freedom;
};

/// Sums over the seeds of one datum.
struct Sums {
  double count = 0.0, sum = 0.0, squares = 0.0, errors2 = 0.0, first = 0.0;

  void add(double value, double error) {
    if (count == 0.0) first = value;  // squares about it: of nearly equal values nothing is lost
    count += 1.0;
    sum += value - first;
    squares += (value - first) * (value - first);
    errors2 += error * error;
  }
  double mean() const { return first + sum / count; }
  double scatter() const { return squares - sum * sum / count; }  ///< about the mean
};

/// chi2 over freedom of all, those left out that are beyond chance of it: found from the median on.
/// Zero where there is nothing.
double pooled(std::vector<Scatter> const& all) {
  constexpr int passes = 20;  // each takes in or leaves out a few at the margin
  std::vector<double> single;
  for (auto const& one : all) single.push_back(one.chi2 / one.freedom);
  if (single.empty()) return 0.0;
  auto const middle = single.begin() + static_cast<std::ptrdiff_t>(single.size() / 2);
  std::ranges::nth_element(single, middle);
  double variance = *middle;
  for (int pass = 0; pass < passes; ++pass) {
    Scatter sum{0.0, 0.0};
    for (auto const& one : all)
      if (one.chi2 <= chance_limit(one.freedom, once_in_1000) * variance) {
        sum.chi2 += one.chi2;
        sum.freedom += one.freedom;
      }
    if (sum.freedom == 0.0) break;
    variance = sum.chi2 / sum.freedom;
  }
  return variance;
}

double freedom_of(std::vector<Scatter> const& all) {
  double sum = 0.0;
  for (auto const& one : all) sum += one.freedom;
  return sum;
}

/// Errors in units of those that the scatter is measured in, with Student's factor.
double widening(std::vector<Scatter> const& all) {
  double const freedom = std::min(freedom_of(all), known);
  return statistics::student_factor(static_cast<std::size_t>(freedom)) * std::sqrt(pooled(all));
}

}  // namespace

SeedErrors seed_errors(SweepTable const& table, Measured const& measured) {
  std::vector<Scatter> told, untold;  // of runs with errors, in units of them; without, of the mean
  double squares = 0.0, count = 0.0;
  for (auto const& rows : seed_groups(table)) {
    Sums all, with_error;
    for (auto const row : rows) {
      double const value = measured.mean[row], error = measured.error[row];
      if (!std::isfinite(value)) continue;
      all.add(value, 0.0);
      if (!std::isfinite(error)) continue;
      with_error.add(value, error);
      if (value == 0.0) continue;
      squares += error * error / (value * value);
      count += 1.0;
    }
    if (with_error.count > 1.0 && with_error.errors2 > 0.0)
      told.push_back(
          {with_error.scatter() * with_error.count / with_error.errors2, with_error.count - 1.0});
    if (all.count > 1.0 && with_error.count < all.count && all.mean() != 0.0)
      untold.push_back({all.scatter() / (all.mean() * all.mean()), all.count - 1.0});
  }
  SeedErrors out{1.0, unknown};
  if (freedom_of(told) >= least_freedom) out.factor = std::max(1.0, widening(told));
  if (freedom_of(untold) >= least_freedom)
    out.relative = widening(untold);
  else if (squares > 0.0)
    out.relative = out.factor * std::sqrt(squares / count);
  return out;
}

}  // namespace bagnold::analysis
