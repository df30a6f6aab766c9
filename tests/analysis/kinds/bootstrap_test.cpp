// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/analysis/kinds/model_kinds.hpp"

namespace bagnold::analysis {
namespace {

/// mu = 0.1 + 0.5 I at ten I, each with `seeds` seeds of known scatter.
SweepTable table_of(int seeds, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.0, 0.01);
  SweepTable table;
  for (int place = 1; place <= 10; ++place)
    for (int seed = 0; seed < seeds; ++seed) {
      double const inertial = 0.01 * place;
      table.keys["disks.packing_fraction"].numbers.push_back(0.84 - 0.001 * place);
      table.keys["disks.seed"].numbers.push_back(seed);
      table.observables["I"].mean.push_back(inertial);
      table.observables["I"].error.push_back(0.0);
      table.observables["mu"].mean.push_back(0.1 + 0.5 * inertial + normal(random));
      table.observables["mu"].error.push_back(0.01);
      ++table.points;
    }
  return table;
}

/// Spread of the fitted slope over many sweeps against what the bootstrap says of each: from
/// resampled seeds, and, where there is one seed, from its error.
TEST(Bootstrap, TellsTheSpreadOfAFittedParameter) {
  std::mt19937_64 random(21);
  for (int const seeds : {1, 2, 6}) {
    SCOPED_TRACE(seeds);
    int const sets = 150;
    double squares = 0.0, told = 0.0;
    Request request;
    request.resamples = 100;
    for (int set = 0; set < sets; ++set) {
      auto const table = table_of(seeds, random);
      request.seed = static_cast<std::uint64_t>(set);
      auto const found = fit_all(
          make_series(table, request, "I", "mu"),
          [](Points const&) { return friction_law_model(); }, {{"b", 1.0}}, true, request);
      squares += std::pow(found.at(0).found.value[1] - 0.5, 2) / sets;
      told += std::pow(found.at(0).bootstrap[1], 2) / sets;
    }
    // a variance from 150 sets is known to 1 / sqrt(75) = 12%
    EXPECT_NEAR(told / squares, 1.0, 0.4);
    // in closed form with equal weights, 0.01^2 / (seeds sum (I - mean)^2)
    EXPECT_NEAR(told, 1e-4 / (seeds * 82.5e-4), 0.15 * told);
  }
}

/// Nothing can be drawn of one seed without an error.
TEST(Bootstrap, IsUnknownWithoutErrors) {
  std::mt19937_64 random(22);
  auto table = table_of(1, random);
  for (double& error : table.observables["mu"].error) error = std::nan("");
  Request request;
  request.resamples = 50;
  auto const found = fit_all(
      make_series(table, request, "I", "mu"), [](Points const&) { return friction_law_model(); },
      {{"b", 1.0}}, true, request);
  EXPECT_GT(found.at(0).found.error[1], 0.0);
  EXPECT_TRUE(std::isnan(found.at(0).bootstrap[1]));
  EXPECT_EQ(found.at(0).bootstrap[2], 0.0);  // b is given
}

}  // namespace
}  // namespace bagnold::analysis
