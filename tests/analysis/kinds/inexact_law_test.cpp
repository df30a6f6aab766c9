// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "src/analysis/fit/models.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

constexpr double x = 1.65, Q0 = 1.89, c = 0.05, phi_J = 0.84335;

/// Crossovers at Q*(phi), 3% of noise at every second phi and 0.5% at the others. Each is off the
/// law by a wave of 7% in ln Q, of its own phase, which no error of its points knows.
SweepTable crossovers(double wave, std::mt19937_64& random, double most = 1000.0) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0.0, 2.0 * M_PI);
  SweepTable table;
  table.origin = "made";
  int place = 0;
  for (double const phi : {0.60, 0.66, 0.70, 0.74, 0.76, 0.78, 0.80, 0.81, 0.82}) {
    double const noise = place++ % 2 == 0 ? 0.005 : 0.03, begin = phase(random);
    for (double const Q : geometric(0.1, most, 14)) {
      auto const law = crossover_model({{0.1, most}, {1.0, 1.0}, {}});
      double const values[] = {2.0, Q0 + c * std::pow(phi_J - phi, -x), 2.5, 1.2};
      double const y = law.value(Q, values) * std::exp(wave * std::sin(begin + std::log(Q)));
      table.keys["disks.packing_fraction"].numbers.push_back(phi);
      table.keys["disks.elasticity"].numbers.push_back(Q);
      table.observables["B_p_el"].mean.push_back(y * (1.0 + noise * normal(random)));
      table.observables["B_p_el"].error.push_back(y * noise);
      ++table.points;
    }
  }
  return table;
}

/// The only row of a divergence, column NAME.
double found(Report const& report, std::string const& name) {
  auto const& columns = report.results.columns;
  auto const at = std::ranges::find(columns, name) - columns.begin();
  return number_in(report.results.rows.at(0).at(static_cast<std::size_t>(at))).value_or(unknown);
}

Request jamming_known() {
  Request request;
  request.phi_j = phi_J;
  request.resamples = 0;
  return request;
}

bool has(std::vector<std::string> const& notes, std::string const& words) {
  return std::ranges::any_of(
      notes, [&](auto const& note) { return note.find(words) != std::string::npos; });
}

/// What the law is off by, errors of its places do not know; their scatter about the divergence
/// does.
TEST(InexactLaw, ItsPlacesWeighAlikeAndErrorsHoldTheTruth) {
  std::mt19937_64 random(27);
  int const sets = 150;
  int inside = 0;
  for (int set = 0; set < sets; ++set) {
    auto const report = divergence(crossovers(0.07, random), jamming_known());
    inside += std::abs(found(report, "x") - x) <= 2.0 * found(report, "x_error");
    EXPECT_TRUE(has(report.notes, "they weigh alike in logarithms"));
  }
  EXPECT_NEAR(inside / static_cast<double>(sets), 0.9545, 4.0 * std::sqrt(0.0455 / sets));
}

/// Places of an exact law weigh by their errors, unless it is asked otherwise.
TEST(InexactLaw, ExactOnesWeighByErrors) {
  std::mt19937_64 random(28);
  auto const table = crossovers(0.0, random);
  auto request = jamming_known();
  auto const report = divergence(table, request);
  EXPECT_FALSE(has(report.notes, "alike"));
  request.weigh = "errors";
  EXPECT_EQ(found(divergence(table, request), "x"), found(report, "x"));
  request.weigh = "alike";
  auto const alike = divergence(table, request);
  EXPECT_GT(found(alike, "x_error"), 1.3 * found(report, "x_error"));
  EXPECT_LT(std::abs(found(alike, "x") - x), 4.0 * found(alike, "x_error"));
}

/// q of an inexact law is that of the range: it is left out where Q ends below 10 Q*, and kept
/// where the law is exact.
TEST(InexactLaw, ExponentsNeedADecade) {
  std::mt19937_64 random(29);
  double const most = 100.0;  // Q* goes from 2.4 to 28
  for (double const wave : {0.0, 0.07}) {
    auto const report = crossover(crossovers(wave, random, most), jamming_known());
    auto const& columns = report.results.columns;
    auto const q = static_cast<std::size_t>(std::ranges::find(columns, "q") - columns.begin());
    for (auto const& row : report.results.rows) {
      double const phi = *number_in(row[0]), place = Q0 + c * std::pow(phi_J - phi, -x);
      bool const reaches = most > 11.0 * place, short_of = most < 9.0 * place;
      if (reaches || wave == 0.0) {
        EXPECT_NE(row[q], "") << phi;
      }
      if (short_of && wave > 0.0) {
        EXPECT_EQ(row[q], "") << phi;
      }
    }
    EXPECT_EQ(has(report.notes, "no q (phi = 0.8"), wave > 0.0);
  }
}

}  // namespace
}  // namespace bagnold::analysis
