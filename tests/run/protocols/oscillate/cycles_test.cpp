// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/oscillate/cycles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/piece_table.hpp"
#include "src/run/warnings/warning.hpp"

namespace bagnold {
namespace {

constexpr double storage = 0.03, viscosity = 0.05, gamma_0 = 1e-6, period = 64;
constexpr double omega = 2 * std::numbers::pi / period, loss = viscosity * omega;

/// Made series: sigma = G gamma + eta gammadot in each window, and `rest`, a function of the time
/// in cycles.
class Oscillations : public testing::Test {
 protected:
  using Rest = std::function<double(double)>;

  bagnold::Run run_of(std::int64_t cycles, double discard, std::vector<Rest> const& rests) const {
    bagnold::Run run;
    run.scene.disks = {"CD", 64, 0.8, 1.0, "equal"};
    run.scene.shear.protocol = "oscillate";
    run.scene.shear.amplitude = gamma_0;
    run.scene.shear.period = period;
    run.scene.shear.cycles = cycles;
    run.scene.shear.cycle_pieces = pieces;
    run.scene.shear.discard = discard;
    run.scene.integration.time_step = period / static_cast<double>(pieces) / 10;
    run.scene.measure.every = 1;
    run.plan = make_plan(run.scene);
    run.box_length = run.scene.box_length();
    for (auto const& rest : rests) {
      auto& windows = run.replicas.emplace_back().measurement.windows;
      windows.columns = SumColumns::count;
      for (std::int64_t w = 0; w < run.plan.windows; ++w) {
        auto const begin = run.plan.window_begin(w), end = run.plan.window_end(w);
        double const rate = run.plan.pieces->at(begin).rate;
        double const middle = static_cast<double>(begin + end - 1) / 2;  // of its samples
        double const strain = run.plan.strain(begin) +
                              rate * run.plan.time_step * (middle - static_cast<double>(begin));
        double const stress =
            storage * strain + viscosity * rate + rest(middle * run.plan.time_step / period);
        std::vector<double> row(windows.columns);
        row[SumColumns::elastic_xy] = -stress * run.box_area();
        row[SumColumns::contacts] = 64 * 4;
        windows.push_back(row, 1.0);
      }
    }
    return run;
  }

  double mean(bagnold::Run const& run, std::string_view name) const {
    auto const list = estimates(run);
    return FinishedRun{run, list}.mean(name);
  }

  bool warns(bagnold::Run const& run) const {
    auto const list = estimates(run);
    for (auto const& one : warnings({run, list}))
      if (one.name == "stress_drift") return true;
    return false;
  }

  std::int64_t pieces = 64;
};

TEST_F(Oscillations, ADriftIsNoModulus) {
  for (std::int64_t const cycles : {1, 2, 3, 8})
    for (double const drift : {0.0, 1e-3, -3.0}) {  // over gamma_0 G'
      SCOPED_TRACE(testing::Message() << cycles << " cycles, " << drift);
      double const D = drift * gamma_0 * storage;
      auto const run = run_of(cycles, cycles == 1 ? 0 : 0.5, {[&](double t) { return 5 + D * t; }});
      EXPECT_NEAR(mean(run, "G_storage"), storage, 1e-6 * storage);
      EXPECT_NEAR(mean(run, "G_loss"), loss, 1e-6 * storage);
      EXPECT_NEAR(mean(run, "sigma_drift"), D, 1e-6 * gamma_0 * storage);
      EXPECT_EQ(warns(run), std::abs(drift) > 1);
    }
}

/// What is left of a relaxation that a cycle sees bend: of G' a hundredth of its drift, of G'' its
/// curvature, and it is warned of.
TEST_F(Oscillations, ARelaxationIsFittedAsFarAsItIsALine) {
  double const D = gamma_0 * storage;  // 0.32 of G' if it is taken for an answer
  auto const run = run_of(8, 0.5, {[&](double t) { return D * 4 * std::exp((4 - t) / 4); }});
  EXPECT_NEAR(mean(run, "G_storage"), storage, 0.02 * storage);
  EXPECT_NEAR(mean(run, "G_loss"), loss, 0.02 * storage);
  EXPECT_NEAR(mean(run, "sigma_drift"), -4 * D * (1 - std::exp(-1.0)) / 4, 0.02 * D);
  EXPECT_TRUE(warns(run));
}

/// Replicas relax to either side, which their mean does not show.
TEST_F(Oscillations, TheDriftOfEachReplicaCounts) {
  double const D = gamma_0 * storage;
  auto const run =
      run_of(4, 0.5, {[&](double t) { return D * t; }, [&](double t) { return -D * t; }});
  EXPECT_NEAR(mean(run, "sigma_drift"), 0, 1e-6 * D);
  EXPECT_TRUE(warns(run));
}

/// Noise of a flow: the drift adds a tenth to the error of G', and no bias; without one it is not
/// warned of.
TEST_F(Oscillations, NoiseIsNoDrift) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  double const size = 0.3 * gamma_0 * storage;
  double square = 0, sum = 0;
  constexpr int many = 200;
  constexpr std::int64_t cycles = 6;
  int warned = 0;
  for (int k = 0; k < many; ++k) {
    auto const run = run_of(cycles, 0.5, {[&](double) { return size * normal(random); }});
    double const off = mean(run, "G_storage") / storage - 1;
    sum += off;
    square += off * off;
    warned += warns(run);
  }
  double const measured = static_cast<double>(cycles / 2 * pieces);
  double const least = 0.3 * std::sqrt(2 / measured);  // of a fit to a sine alone
  EXPECT_LT(std::sqrt(square / many), 1.25 * least);
  EXPECT_GT(std::sqrt(square / many), 0.85 * least);
  EXPECT_LT(std::abs(sum / many), 4 * least / std::sqrt(many));
  EXPECT_LE(warned, many / 20);
}

TEST_F(Oscillations, TheTableHasEachCycle) {
  auto const run = run_of(4, 0.5, {[](double) { return 0.0; }, [](double) { return 0.0; }});
  auto const table = cycle_table(run);
  auto const columns = table.columns.size();
  ASSERT_EQ(table.rows.size(), 8 * columns);
  EXPECT_EQ(table.columns[3], "G_storage [m/tau_e^2]");
  for (std::size_t k = 0; k < 8; ++k) {
    auto const row = std::span(table.rows).subspan(k * columns, columns);
    EXPECT_EQ(row[0], k < 4 ? 1 : 2);  // seed
    EXPECT_EQ(row[1], k % 4 + 1);
    EXPECT_EQ(row[2], k % 4 < 2 ? 0 : 1);  // measured
    EXPECT_NEAR(row[3], storage, 1e-9);
  }
}

}  // namespace
}  // namespace bagnold
