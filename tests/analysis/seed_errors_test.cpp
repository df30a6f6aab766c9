// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/seed_errors.hpp"

#include <gtest/gtest.h>

#include <random>

#include "src/analysis/fit/chance.hpp"
#include "src/analysis/quantity.hpp"
#include "tests/analysis/tables.hpp"

namespace bagnold::analysis {
namespace {

/// Runs of a made sweep: true values from 1 to 40, true errors of 5%.
struct Made {
  int seeds;
  double told = 1;     ///< errors that runs tell, over the true ones
  double without = 0;  ///< share of runs that tell none
  double jumps = 0;    ///< share of data whose seeds lie twenty errors apart, in one of two states
};

constexpr int places = 40;
constexpr double relative = 0.05;

SweepTable made_table(Made const& made, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share;
  std::gamma_distribution<double> chi2(15.0 / 2.0, 2.0 / 15.0);  // of 16 blocks
  SweepTable table;
  for (int place = 1; place <= places; ++place) {
    bool const jumps = share(random) < made.jumps;
    for (int seed = 0; seed < made.seeds; ++seed) {
      double const truth = place, error = relative * truth;
      double const state = jumps ? (share(random) < 0.5 ? 10 : -10) : 0.0;
      table.keys["disks.elasticity"].numbers.push_back(place);
      table.keys["disks.seed"].numbers.push_back(seed);
      auto& p = table.observables["p"];
      p.mean.push_back(truth + error * (state + normal(random)));
      p.error.push_back(share(random) < made.without ? nothing
                                                     : made.told * error * std::sqrt(chi2(random)));
      ++table.points;
    }
  }
  return table;
}

/// Share of data whose truth lies within 1.96 of their errors.
double coverage(Made const& made, int sets) {
  std::mt19937_64 random(77);
  double inside = 0.0;
  for (int set = 0; set < sets; ++set) {
    auto const table = made_table(made, random);
    Quantity const p(table, "p");
    for (auto const& rows : seed_groups(table)) {
      auto const value = p.of(rows);
      double const truth = table.keys.at("disks.elasticity").numbers[rows.front()];
      EXPECT_TRUE(std::isfinite(value.error));
      inside += std::abs(value.mean - truth) < 1.96 * value.error;
    }
  }
  return inside / (sets * places);
}

TEST(SeedErrors, IntervalsHoldTheTruth) {
  int const sets = 100;  // coverage is known to 0.3%
  for (int const seeds : {1, 2, 3, 5}) {
    SCOPED_TRACE(seeds);
    EXPECT_NEAR(coverage({seeds}, sets), 0.95, 0.03) << "right errors";
    EXPECT_NEAR(coverage({seeds, 1.0, 0.5}, sets), 0.95, 0.03) << "half of the runs have none";
    if (seeds == 1) continue;
    EXPECT_NEAR(coverage({seeds, 0.6}, sets), 0.95, 0.03) << "errors too small";
    EXPECT_NEAR(coverage({seeds, 1.0, 1.0}, sets), 0.95, 0.03) << "no errors";
    EXPECT_NEAR(coverage({seeds, 0.6, 0.5}, sets), 0.95, 0.03) << "few and too small";
  }
}

/// Seeds in one of two states: where they differ they speak for themselves, and do not widen the
/// errors of the others. (Where all chance to be in one state nothing tells: once in sixteen.)
TEST(SeedErrors, DataThatJumpSpeakForThemselves) {
  std::mt19937_64 random(5);
  auto const table = made_table({5, 1.0, 0.0, 0.2}, random);
  EXPECT_NEAR(seed_errors(table, table.observables.at("p")).factor, 1.0, 0.15);
  EXPECT_GT(coverage({5, 1.0, 0.0, 0.2}, 100), 0.92);
}

TEST(SeedErrors, AreWhatTheRunsTellTogether) {
  std::mt19937_64 random(6);
  auto const of = [&](Made const& made) {
    auto const table = made_table(made, random);
    return seed_errors(table, table.observables.at("p"));
  };
  EXPECT_NEAR(of({5, 0.5}).factor, 2.0, 0.2);
  EXPECT_NEAR(of({5, 2.0}).factor, 1.0, 1e-12);           // never narrowed
  EXPECT_EQ(of({1, 0.5}).factor, 1.0);                    // one seed does not scatter
  EXPECT_NEAR(of({1, 0.5, 0.5}).relative, 0.025, 0.003);  // as the others have it
  EXPECT_NEAR(of({4, 0.5, 0.5}).relative, 0.05, 0.01);    // as their seeds scatter
  EXPECT_NEAR(of({4, 0.5, 1.0}).relative, 0.05, 0.01);
  EXPECT_TRUE(std::isnan(of({1, 0.5, 1.0}).relative));
}

TEST(Chance, LimitsAreThoseOfTables) {
  EXPECT_NEAR(chance_limit(1), 6.63, 0.1);
  EXPECT_NEAR(chance_limit(4), 13.28, 0.1);
  EXPECT_NEAR(chance_limit(10, once_in_1000), 29.59, 0.2);
}

}  // namespace
}  // namespace bagnold::analysis
