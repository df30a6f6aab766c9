// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/student.hpp"

#include <cmath>
#include <numbers>

namespace bagnold::statistics {

double student_probability(double value, std::size_t freedom) {
  double const theta = std::atan(value / std::sqrt(static_cast<double>(freedom)));
  double const cosine = std::cos(theta);
  bool const odd = freedom % 2 == 1;
  double term = odd ? cosine : 1.0, sum = freedom > 1 ? term : 0.0;
  for (std::size_t power = odd ? 3 : 2; power + 2 <= freedom; power += 2) {
    double const k = static_cast<double>(power);
    term *= (k - 1.0) / k * cosine * cosine;
    sum += term;
  }
  double const even = std::sin(theta) * sum;
  return odd ? 2.0 / std::numbers::pi * (theta + even) : even;
}

namespace {

/// Value between two others that |t| stays below with the wanted probability.
double value_of(double wanted, std::size_t freedom, double below, double above) {
  for (int halving = 0; halving < 60; ++halving) {
    double const middle = (below + above) / 2.0;
    (student_probability(middle, freedom) < wanted ? below : above) = middle;
  }
  return above;
}

}  // namespace

double student_factor(std::size_t freedom) {
  return value_of(std::erf(std::numbers::sqrt2), freedom, 2.0, 16.0) / 2.0;  // 14.0 for one
}

double student_quantile(std::size_t freedom) { return value_of(0.95, freedom, 0.0, 16.0); }

}  // namespace bagnold::statistics
