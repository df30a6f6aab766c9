// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/quantity.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <numeric>
#include <random>

#include "src/config/errors.hpp"
#include "src/io/result_file.hpp"
#include "src/statistics/student.hpp"
#include "tests/analysis/tables.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::analysis {
namespace {

TEST(Quantity, SeedsAreMerged) {
  std::vector<double> const means{1, 2, 3, nothing}, small{0.1, 0.1, 0.1, nothing},
      large{3, 3, 3, 3}, unknown{nothing, 0.1, 0.1, 0.1};
  EXPECT_DOUBLE_EQ(merge_seeds(means, small).mean, 2.0);
  double const of_three =
      statistics::student_factor(2) * std::sqrt(2.0 / 6.0);  // scatter of three seeds
  EXPECT_DOUBLE_EQ(merge_seeds(means, small).error, of_three);
  EXPECT_DOUBLE_EQ(merge_seeds(means, large).error, std::sqrt(27.0) / 3.0);  // their own
  EXPECT_DOUBLE_EQ(merge_seeds(means, unknown).error, of_three);
  // chi2 at 1% is 6.63 for two seeds: a difference of sqrt(2 6.63) = 3.64 errors
  std::vector<double> const near{0, 3.5}, far{0, 3.8}, unit{1, 1};
  EXPECT_DOUBLE_EQ(merge_seeds(near, unit).error, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(merge_seeds(far, unit).error, 1.9 * statistics::student_factor(1));
  std::vector<double> const one{5}, no_error{nothing}, none{nothing};
  EXPECT_TRUE(std::isnan(merge_seeds(one, no_error).error));
  EXPECT_TRUE(std::isnan(merge_seeds(none, none).mean));
}

TEST(Quantity, ByName) {
  auto const table = small_table();
  std::vector<std::size_t> const seeds{0, 1, 2};  // phi = 0.7, rate 1e-4
  auto const p = Quantity(table, "p").of(seeds);
  EXPECT_NEAR(p.mean, 70.0 + 1e-4 + 0.002, 1e-12);
  EXPECT_NEAR(Quantity(table, "phi_J-phi", 0.84335).of(seeds).mean, 0.14335, 1e-12);
  auto const ratio = Quantity(table, "p/shear.strain_rate").of(seeds);
  EXPECT_NEAR(ratio.mean, p.mean / 1e-4, 1e-6);
  EXPECT_NEAR(ratio.error, p.error / 1e-4, 1e-9);
  auto const product = Quantity(table, "p*p/shear.strain_rate").of(seeds);
  EXPECT_NEAR(product.mean, p.mean * p.mean / 1e-4, 1e-3);
  // the seeds have p - 0.001, p, p + 0.001: 2 p times the error of that
  double const of_p = statistics::student_factor(2) * 0.001 / std::sqrt(3.0);
  EXPECT_NEAR(product.error, 2.0 * p.mean * of_p / 1e-4, 1e-3);
  EXPECT_THROW(Quantity(table, "phi_J-phi"), InputError);
  EXPECT_THROW(Quantity(table, "disks.elasticity"), InputError);
  // a near word is proposed, and where none is near all are listed
  for (auto const& [wrong, said] : {std::pair{"P", "did you mean p?"},
                                    {"P_el", "(no such observable or key in made). There are: p"}})
    try {
      Quantity(table, wrong);
      ADD_FAILURE() << wrong;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
}

/// p and sigma = 0.3 p of one run vary together by 10%, their ratio by 1%.
SweepTable correlated_table(std::size_t seeds, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  SweepTable table;
  table.origin = "made";
  table.points = seeds;
  for (std::size_t k = 0; k < seeds; ++k) {
    double const p = 1.0 + 0.1 * normal(random);
    table.keys["disks.seed"].numbers.push_back(static_cast<double>(k));
    table.observables["p"].mean.push_back(p);
    table.observables["p"].error.push_back(0.1);
    table.observables["sigma"].mean.push_back(0.3 * p * (1.0 + 0.01 * normal(random)));
    table.observables["sigma"].error.push_back(0.03);
  }
  return table;
}

TEST(Quantity, RatiosHaveTheErrorOfWhatVariesTogether) {
  std::mt19937_64 random(4);
  for (std::size_t const seeds : {3, 5}) {
    std::vector<std::size_t> rows(seeds);
    std::iota(rows.begin(), rows.end(), 0);
    int inside = 0, product_inside = 0;
    int const sets = 2000;
    double squares = 0.0;
    for (int set = 0; set < sets; ++set) {
      auto const table = correlated_table(seeds, random);
      auto const ratio = Quantity(table, "sigma/p").of(rows);
      inside += std::abs(ratio.mean - 0.3) <= 2.0 * ratio.error;
      squares += ratio.error * ratio.error / sets;
      auto const product = Quantity(table, "sigma*p").of(rows);
      product_inside += std::abs(product.mean - 0.3) <= 2.0 * product.error;
    }
    EXPECT_NEAR(inside / 2000.0, 0.9545, 4.0 * std::sqrt(0.9545 * 0.0455 / sets)) << seeds;
    EXPECT_NEAR(product_inside / 2000.0, 0.9545, 0.03) << seeds;  // its scatter is not quite normal
    double const n = static_cast<double>(seeds);
    EXPECT_NEAR(std::sqrt(squares), statistics::student_factor(seeds - 1) * 0.003 / std::sqrt(n),
                0.1 * 0.003)
        << seeds;
  }
}

TEST(Quantity, RatiosOfTwoSeedsTakeErrorsAsIndependent) {
  std::mt19937_64 random(5);
  std::vector<std::size_t> const rows{0, 1};
  auto const table = correlated_table(2, random);
  auto const p = Quantity(table, "p").of(rows), sigma = Quantity(table, "sigma").of(rows);
  auto const ratio = Quantity(table, "sigma/p").of(rows);
  EXPECT_DOUBLE_EQ(ratio.mean, sigma.mean / p.mean);
  EXPECT_DOUBLE_EQ(ratio.error,
                   ratio.mean * std::hypot(sigma.error / sigma.mean, p.error / p.mean));
}

/// A sweep of runs of `windows` windows, their series in result.h5: p and sigma = 0.3 p vary
/// together by 20%, slowly, their ratio by 2%; contacts begin and end, and Z is their durations'
/// sum, but for what windows cut. Returns the table; the exact ratios of a run's averages are those
/// of its means.
SweepTable runs_of_series(std::filesystem::path const& folder, int runs, std::size_t windows,
                          std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::exponential_distribution<double> duration(1.0 / 50.0);
  SweepTable table;
  table.origin = "made";
  for (int run = 0; run < runs; ++run) {
    std::map<std::string, std::vector<double>> series;
    double slow = normal(random), before = 0.0;
    double ended = 0.0, lasted = 0.0, begun = 0.0, stayed = 0.0;
    for (std::size_t w = 0; w < windows; ++w) {
      slow = 0.95 * slow + std::sqrt(1.0 - 0.95 * 0.95) * normal(random);
      double const p = 1.0 + 0.2 * slow;
      std::poisson_distribution<int> number(40.0 * (1.0 + 0.3 * std::max(-3.0, slow)) + 1.0),
          open(4.0);
      int const ends = number(random) + 1, now = open(random);
      double const begins = std::max(0.0, ends + now - before);
      before = now;
      double sum = 0.0;
      for (int k = 0; k < ends; ++k) sum += duration(random) * p;
      ended += ends, lasted += sum, begun += begins;
      double const contacts = 2.0 * sum / 1000.0 * (1.0 + 0.01 * normal(random));
      stayed += contacts;
      series["evaluations"].push_back(10.0);
      series["p"].push_back(p);
      series["sigma"].push_back(0.3 * p * (1.0 + 0.02 * normal(random)));
      series["tau_dur"].push_back(sum / ends);
      series["nu_coll"].push_back(begins / 1000.0);
      series["nu_end"].push_back(ends / 1000.0);
      series["Z"].push_back(contacts);
    }
    double const n = static_cast<double>(windows);
    auto const add = [&](std::string const& name, double mean, double error) {
      table.observables[name].mean.push_back(mean);
      table.observables[name].error.push_back(error);
    };
    for (auto const* name : {"p", "sigma"})
      add(name, std::accumulate(series[name].begin(), series[name].end(), 0.0) / n, 0.03);
    add("tau_dur", lasted / ended, 2.0);
    add("nu_coll", begun / n / 1000.0, 0.001);
    add("Z", stayed / n, 0.1);
    table.keys["disks.elasticity"].numbers.push_back(run);
    ++table.points;
    table.runs.push_back(folder / std::to_string(run));
    std::filesystem::create_directory(table.runs.back());
    io::Result result;
    for (auto const& [name, values] : series) {
      // a transient that is discarded
      std::vector<double> all(100, 1e3);
      all.insert(all.end(), values.begin(), values.end());
      result.series.push_back({name, "1", "made", all});
    }
    result.discarded_windows = 100;
    io::write_result(table.runs.back() / "result.h5", result);
  }
  return table;
}

/// Of one seed: what varies together does not count, and two errors hold the truth.
TEST(Quantity, RatiosOfOneSeedHaveTheErrorOfTheirOwnBlocks) {
  io::TestFolder const folder;
  std::mt19937_64 random(28);
  int const runs = 200;
  auto const table = runs_of_series(folder.path(), runs, 1000, random);
  struct Case {
    char const* name;
    double truth;
    double independent;  ///< error of the ratio, were its parts independent
    double most;         ///< times the scatter of runs that its error is
  };
  for (auto const& [name, truth, independent, most] :
       {Case{"sigma/p", 0.3, 0.04, 1.15}, Case{"tau_dur*nu_coll/Z", 0.5, 0.05, 1.7}}) {
    Quantity const ratio(table, name);
    int inside = 0;
    double squares = 0.0, told = 0.0;
    for (std::size_t row = 0; row < table.points; ++row) {
      std::vector<std::size_t> const rows{row};
      auto const found = ratio.of(rows);
      inside += std::abs(found.mean - truth) <= 2.0 * found.error;
      squares += std::pow(found.mean - truth, 2) / runs;
      told += found.error * found.error / runs;
    }
    EXPECT_GT(inside / static_cast<double>(runs), 0.9545 - 4.0 * std::sqrt(0.0455 / runs)) << name;
    EXPECT_GT(std::sqrt(told / squares), 0.85) << name;
    EXPECT_LT(std::sqrt(told / squares), most) << name;
    EXPECT_LT(std::sqrt(told), independent / 10.0) << name;
    // the bootstrap of a single seed draws it from that
    std::vector<std::size_t> const rows{0};
    double spread = 0.0;
    for (std::uint32_t replica = 1; replica <= 1000; ++replica)
      spread += std::pow(ratio.resampled(rows, {1, replica, 0}) - ratio.of(rows).mean, 2) / 1000;
    EXPECT_NEAR(std::sqrt(spread) / ratio.of(rows).error, 1.0, 0.1) << name;
  }
}

/// Runs that are gone, and tables without series, leave the errors of before; a table may have the
/// ratio as a column.
TEST(Quantity, RatiosWithoutSeries) {
  io::TestFolder const folder;
  std::mt19937_64 random(29);
  auto table = runs_of_series(folder.path(), 2, 300, random);
  std::vector<std::size_t> const rows{0};
  double const own = Quantity(table, "sigma/p").of(rows).error;
  auto gone = table;
  gone.ratio_errors = std::make_shared<std::map<std::string, std::vector<double>>>();
  for (auto& run : gone.runs) run += "-gone";
  double const independent = Quantity(gone, "sigma/p").of(rows).error;
  EXPECT_GT(independent, 10.0 * own);
  gone.observables["sigma/p"] = {{0.3, 0.3}, {own, own}};
  EXPECT_DOUBLE_EQ(Quantity(gone, "sigma/p").of(rows).error, own);
  EXPECT_DOUBLE_EQ(Quantity(gone, "sigma/p").of(rows).mean,
                   Quantity(table, "sigma/p").of(rows).mean);
}

/// error^2 + bias^2 + bias_error^2 of one run; all seeds have the bias, so it does not average out.
TEST(Quantity, BiasesAreAddedToErrors) {
  SweepTable table;
  table.origin = "made";
  table.points = 4;
  table.keys["disks.seed"].numbers = {1, 2, 3, 4};
  table.observables["p"] = {{1.0, 1.0, 1.0, 1.0}, {0.1, 0.1, 0.1, 0.1}};
  table.observables["p_bias"] = {{-0.2, -0.2, -0.2, nothing}, {0.2, 0.2, 0.2, nothing}};
  table.observables["sigma"] = {{0.5, 0.5, 0.5, 0.5}, {0.01, 0.01, 0.01, 0.01}};
  std::vector<std::size_t> const one{0}, all{0, 1, 2, 3}, last{3};
  Quantity const p(table, "p");
  EXPECT_NEAR(p.of(one).error, 0.3, 1e-15);
  EXPECT_NEAR(p.without_bias(one).error, 0.1, 1e-15);
  EXPECT_NEAR(p.of(last).error, 0.1, 1e-15);
  double const of_bias = 0.2 * 0.2 + 0.2 * 0.2 / 3;
  EXPECT_NEAR(p.of(all).error, std::sqrt(0.1 * 0.1 / 4 + of_bias), 1e-15);
  EXPECT_DOUBLE_EQ(p.of(all).mean, 1.0);
  // to first order: sigma/p is 20% too large, p/sigma too small, what both have is not in the ratio
  EXPECT_NEAR(Quantity(table, "sigma/p").of(one).error,
              0.5 * std::hypot(0.1, 0.02, std::sqrt(0.2 * 0.2 + 0.2 * 0.2)), 1e-15);
  EXPECT_NEAR(Quantity(table, "p*sigma").of(one).error,
              0.5 * std::hypot(0.1, 0.02, std::sqrt(0.2 * 0.2 + 0.2 * 0.2)), 1e-15);
  for (double& mean : table.observables["p"].mean) mean *= -1.0;  // a sign changes no error
  EXPECT_NEAR(Quantity(table, "sigma/p").of(one).error,
              0.5 * std::hypot(0.1, 0.02, std::sqrt(0.2 * 0.2 + 0.2 * 0.2)), 1e-15);
  for (double& mean : table.observables["p"].mean) mean *= -1.0;
  table.observables["sigma_bias"] = {{-0.1, -0.1, -0.1, nothing}, {0.0, 0.0, 0.0, nothing}};
  EXPECT_NEAR(Quantity(table, "sigma/p").of(one).error, 0.5 * std::hypot(0.1, 0.02, 0.2), 1e-15);
  EXPECT_NEAR(Quantity(table, "p*sigma").of(one).error,
              0.5 * std::hypot(0.1, 0.02, std::hypot(0.4, 0.2)), 1e-15);
}

/// Seeds without a value are not drawn: of one that has it the spread is its error.
TEST(Quantity, ARatioIsOfSeedsThatHaveBoth) {
  auto table = small_table();
  auto& b = table.observables["b"];
  b = table.observables["p"];
  for (std::size_t k = 0; k < table.points; ++k) b.mean[k] = 2 * table.observables["p"].mean[k];
  b.mean[2] = nothing;
  std::vector<std::size_t> const seeds{0, 1, 2};
  EXPECT_NEAR(Quantity(table, "b/p").of(seeds).mean, 2.0, 1e-12);
  EXPECT_NEAR(Quantity(table, "p/b").without_bias(seeds).mean, 0.5, 1e-12);
}

TEST(Quantity, ResamplingLeavesOutSeedsWithoutAValue) {
  auto table = small_table();
  table.observables["sigma"] = table.observables["p"];
  table.observables["sigma"].mean[1] = table.observables["sigma"].mean[2] = nothing;
  std::vector<std::size_t> const seeds{0, 1, 2}, none{1, 2};
  for (auto const* name : {"sigma", "sigma/p"}) {
    Quantity const sigma(table, name);
    double squares = 0.0;
    for (std::uint32_t replica = 1; replica <= 4000; ++replica)
      squares += std::pow(sigma.resampled(seeds, {7, replica, 0}) -
                              sigma.of(std::vector<std::size_t>{0}).mean,
                          2) /
                 4000;
    double const error = sigma.of(std::vector<std::size_t>{0}).error;
    EXPECT_NEAR(std::sqrt(squares), error, 0.05 * error) << name;
    EXPECT_TRUE(std::isnan(sigma.resampled(none, {7, 1, 0}))) << name;
  }
}

/// A run that is stopped before its first window has ended has no error yet.
TEST(Quantity, RatiosOfRunsWithoutAWindow) {
  io::TestFolder const folder;
  std::mt19937_64 random(30);
  auto table = runs_of_series(folder.path(), 1, 300, random);
  io::Result result;
  for (auto const* name : {"evaluations", "p", "sigma"})
    result.series.push_back({name, "1", "made", {}});
  io::write_result(table.runs.front() / "result.h5", result);
  std::vector<std::size_t> const rows{0};
  EXPECT_NEAR(Quantity(table, "sigma/p").of(rows).mean, 0.3, 0.02);
}

/// The variance of a mean over 3 seeds, each of variance 1, is 1/3: resampling tells that on
/// average, from 3 values at a time.
TEST(Quantity, ResamplingHasTheRightSpread) {
  std::mt19937_64 random(15);
  std::normal_distribution<double> normal;
  auto table = small_table();
  std::vector<std::size_t> const seeds{0, 1, 2}, single{0};
  int const sets = 400;
  std::uint32_t const resamples = 200;
  double average = 0.0;
  for (int set = 0; set < sets; ++set) {
    for (auto const row : seeds) table.observables["p"].mean[row] = normal(random);
    Quantity const p(table, "p");
    double const mean = p.of(seeds).mean;
    for (std::uint32_t replica = 1; replica <= resamples; ++replica) {
      double const off = p.resampled(seeds, {7, replica, 0}) - mean;
      average += off * off / (sets * resamples);
    }
  }
  // the variance of a variance from 3 values is (2 / 2) (1/3)^2: four standard errors of the mean
  EXPECT_NEAR(average, 1.0 / 3.0, 4.0 / 3.0 / std::sqrt(sets));

  Quantity const p(table, "p");
  double squares = 0.0;
  for (std::uint32_t replica = 1; replica <= 4000; ++replica) {
    double const off = p.resampled(single, {7, replica, 0}) - p.of(single).mean;
    squares += off * off / 4000;
  }
  double const own = p.of(single).error;  // the seed's own, widened as the sweep tells
  EXPECT_NEAR(own, 0.001 * p.widened(), 1e-12);
  EXPECT_NEAR(std::sqrt(squares), own, 0.05 * own);
  table.observables["p_bias"] = {std::vector<double>(table.points, 1.0),
                                 std::vector<double>(table.points, 1.0)};
  Quantity const biased(table, "p");  // all points share a bias: it is no part of the spread
  EXPECT_EQ(biased.resampled(single, {7, 1, 0}), p.resampled(single, {7, 1, 0}));
}

TEST(Quantity, ResamplingIsRepeatableAndTakesTheSameSeedsForAll) {
  auto table = small_table();
  table.observables["sigma"] = table.observables["p"];
  std::vector<std::size_t> const seeds{0, 1, 2};
  Quantity const p(table, "p"), sigma(table, "sigma"), ratio(table, "sigma/p");
  bool changes = false;
  for (std::uint32_t replica = 1; replica <= 50; ++replica) {
    Draw const draw{3, replica, 0};
    EXPECT_EQ(p.resampled(seeds, draw), p.resampled(seeds, draw));
    EXPECT_EQ(p.resampled(seeds, draw), sigma.resampled(seeds, draw));
    EXPECT_EQ(ratio.resampled(seeds, draw), 1.0);
    changes = changes || p.resampled(seeds, draw) != p.resampled(seeds, {4, replica, 0});
  }
  EXPECT_TRUE(changes);
  EXPECT_EQ(p.resampled(seeds, {3, 0, 0}), p.of(seeds).mean);
}

}  // namespace
}  // namespace bagnold::analysis
