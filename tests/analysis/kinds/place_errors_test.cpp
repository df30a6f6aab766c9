// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/analysis/kinds/kinds.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

constexpr double spacing = 0.005;

/// y = shape((phi - place) / spacing) at 13 phi, all but exact.
SweepTable curve(std::function<double(double)> const& shape, double place) {
  SweepTable table;
  table.origin = "made";
  for (int i = 0; i < 13; ++i) {
    double const phi = 0.77 + spacing * i;
    table.keys["disks.packing_fraction"].numbers.push_back(phi);
    table.observables["y"].mean.push_back(shape((phi - place) / spacing));
    table.observables["y"].error.push_back(1e-5);
    ++table.points;
  }
  return table;
}

struct Place {
  double value, error, bootstrap;
};

Place place_of(Report const& report) {
  auto const& row = report.results.rows.at(0);
  return {*number_in(row[0]), *number_in(row[1]), number_in(row[2]).value_or(unknown)};
}

Request request_for_y(std::uint32_t resamples = 0) {
  Request request;
  request.y = "y";
  request.resamples = resamples;
  return request;
}

/// Peaks of many shapes, symmetric or not, anywhere between two points: two errors hold their
/// place.
TEST(PlaceErrors, HoldPeaksOfAnyShape) {
  std::map<std::string, std::function<double(double)>> const shapes{
      {"Gaussian, 0.7 spacings", [](double d) { return std::exp(-d * d); }},
      {"Gaussian, 2 spacings", [](double d) { return std::exp(-d * d / 8); }},
      {"Lorentzian", [](double d) { return 1 / (1 + d * d); }},
      {"narrow Lorentzian", [](double d) { return 1 / (1 + 4 * d * d); }},
      {"cusp", [](double d) { return 10 - std::abs(d); }},
      {"cusp, 1 : 2", [](double d) { return 20 - (d < 0 ? -d : 2 * d); }},
      {"cusp, 1 : 4", [](double d) { return 40 - (d < 0 ? -d : 4 * d); }},
      {"skew, 1 : 2", [](double d) { return std::exp(-d * d / (d < 0 ? 2 : 8)); }}};
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  int const sets = 300;
  for (auto const& [name, shape] : shapes) {
    int inside = 0;
    for (int set = 0; set < sets; ++set) {
      double const truth = 0.80 + spacing * offset(random);
      auto const found = place_of(peak(curve(shape, truth), request_for_y()));
      inside += std::abs(found.value - truth) <= 2.0 * found.error;
      EXPECT_GE(found.error, spacing / (2.0 * std::sqrt(12.0))) << name;
      EXPECT_LE(found.error, 1.1 * spacing) << name;
    }
    EXPECT_GT(inside / static_cast<double>(sets), 0.93) << name;
  }
}

/// A kink that is rounded over a spacing, between branches that bend a little.
TEST(PlaceErrors, HoldKinks) {
  auto const shape = [](double d) { return d + 2 * std::sqrt(d * d + 1) + 0.02 * d * d; };
  std::mt19937_64 random(30);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  int const sets = 100;
  int inside = 0;
  for (int set = 0; set < sets; ++set) {
    double const truth = 0.80 + spacing * offset(random);
    auto const found = place_of(kink(curve(shape, truth), request_for_y()));
    inside += std::abs(found.value - truth) <= 2.0 * found.error;
  }
  EXPECT_GT(inside, 93);
}

/// Exact points of exact straight pieces: the grid's share is left, in the bootstrap too.
TEST(PlaceErrors, AreNotBelowAShareOfTheSpacing) {
  double const least = spacing / (2.0 * std::sqrt(12.0));
  auto const straight = [](double d) { return 2 + 0.01 * d + std::max(0.0, 0.2 * d); };
  auto const parabola = [](double d) { return 3 - d * d; };
  auto const kinked = place_of(kink(curve(straight, 0.8013), request_for_y(400)));
  auto const peaked = place_of(peak(curve(parabola, 0.8013), request_for_y(400)));
  for (auto const& one : {kinked, peaked}) {
    EXPECT_NEAR(one.value, 0.8013, 1e-5);
    EXPECT_NEAR(one.error, least, 0.01 * least);
    EXPECT_NEAR(one.bootstrap, least, 0.1 * least);
  }
}

/// Where x covers decades the parabola is one in ln x, as it is drawn.
TEST(PlaceErrors, APeakOverDecadesIsOneOfTheLogarithm) {
  double const truth = 13.0, step = std::log(10.0) / 4;
  SweepTable table;
  table.origin = "made";
  for (int i = 0; i < 13; ++i) {
    double const log_q = step * i, off = log_q - std::log(truth);
    table.keys["disks.elasticity"].numbers.push_back(std::exp(log_q));
    table.observables["y"].mean.push_back(3 - off * off);
    table.observables["y"].error.push_back(1e-5);
    ++table.points;
  }
  auto request = request_for_y(400);
  request.x = "disks.elasticity";
  auto const found = place_of(peak(table, request));
  double const least = truth * step / (2.0 * std::sqrt(12.0));
  EXPECT_NEAR(found.value, truth, 1e-3);
  EXPECT_NEAR(found.error, least, 0.01 * least);
  EXPECT_NEAR(found.bootstrap, least, 0.1 * least);
  // not where x has no logarithm
  for (double& x : table.keys["disks.elasticity"].numbers) x = std::log(x);
  EXPECT_NEAR(place_of(peak(table, request)).value, std::log(truth), 1e-3);
}

}  // namespace
}  // namespace bagnold::analysis
