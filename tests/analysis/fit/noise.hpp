// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

inline std::vector<double> evenly(double low, double high, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(low + (high - low) * i / (count - 1));
  return out;
}

inline std::vector<double> geometric(double low, double high, int count) {
  auto out = evenly(std::log(low), std::log(high), count);
  for (double& x : out) x = std::exp(x);
  return out;
}

/// A curve with normal noise of the size `error(y)`; none without a generator.
inline Points sampled(std::vector<double> const& x, std::function<double(double)> const& curve,
                      std::function<double(double)> const& error, std::mt19937_64* random) {
  Points points;
  std::normal_distribution<double> normal;
  for (double const place : x) {
    double const y = curve(place);
    points.x.push_back(place);
    points.y.push_back(y + (random == nullptr ? 0.0 : error(y) * normal(*random)));
    points.error.push_back(error(y));
  }
  return points;
}

/// (found - true) / error over many synthetic sets: mean 0 and variance 1 where errors are right.
struct Pulls {
  double sum = 0.0, squares = 0.0;
  int count = 0;

  void add(double found, double truth, double error) {
    double const pull = (found - truth) / error;
    sum += pull;
    squares += pull * pull;
    ++count;
  }
  double mean() const { return sum / count; }
  double variance() const { return squares / count - mean() * mean(); }

  /// Within four standard errors, and what is allowed for curvature beyond the first order.
  void expect_right(double curvature = 0.0) const {
    double const n = count;
    EXPECT_NEAR(mean(), 0.0, 4.0 / std::sqrt(n) + curvature);
    EXPECT_NEAR(variance(), 1.0, 4.0 * std::sqrt(2.0 / n) + curvature);
  }
};

}  // namespace bagnold::analysis
