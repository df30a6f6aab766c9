// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/observables.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A steady state, as far as a short run reaches it.
struct Point {
  char const* name;
  char const* law;
  double packing_fraction, elasticity;
  double rate = 1e-2;
};

/// Engines go one way only for so long: after some collisions their trajectories have nothing in
/// common but the statistics, which must agree.
class Statistics : public testing::TestWithParam<Point> {
 public:
  static constexpr double warm_up = 4, strain = 24;
  static constexpr int blocks = 16;  ///< of a run, as independent as their means are taken to be

  static Scene scene() {
    Point const& p = GetParam();
    Scene scene;
    scene.disks = {p.law, 1024, p.packing_fraction, p.elasticity, "equal"};
    scene.shear.strain_rate = p.rate;
    scene.shear.strain = strain;
    scene.integration.scheme = papers_scheme;
    scene.integration.time_step = 0.05;
    return scene;
  }

  static std::int64_t steps(double strain) {
    return std::llround(strain / (GetParam().rate * 0.05));
  }

  /// The averages of each block, [blocks][columns].
  static std::vector<WindowSums> run(std::string const& engine, State const& state) {
    Scene plain = scene();
    plain.integration.engine = engine;
    auto const simulation = simulate(plain, state, backend_names().front());
    OpenWindows open;
    simulation->advance(steps(strain), {steps(strain / blocks), 10, steps(strain)}, open);
    for (auto& block : open.sums)
      for (double& sum : block.sums) sum /= block.weight;
    return open.sums;
  }

  struct Mean {
    double value, error;
  };
  static Mean mean(std::vector<WindowSums> const& run, Observable const& observable) {
    double sum = 0, sum2 = 0;
    for (auto const& block : run) {
      double const value = observable.value(block.sums);
      sum += value;
      sum2 += value * value;
    }
    double const value = sum / blocks;
    return {value, std::sqrt((sum2 / blocks - value * value) / (blocks - 1))};
  }
};

TEST_P(Statistics, OfEveryEngineAreThoseOfTheReference) {
  auto const warm = simulate(scene(), random_start(scene()).state, backend_names().front());
  advance(*warm, steps(warm_up));
  State const state = warm->state();
  auto const expected = run("reference", state);
  for (std::string const engine : {"few-contacts", "many-contacts", "lookahead"}) {
    auto const found = run(engine, state);
    for (auto const& observable : observables(scene(), state.box_length)) {
      std::string const name(observable.name);
      if (name != "B_p" && name != "B_sigma" && name != "Z" && name != "R_v") continue;
      auto const a = mean(found, observable), b = mean(expected, observable);
      double const apart = (a.value - b.value) / std::hypot(a.error, b.error);
      RecordProperty(engine + "_" + name + "_standard_errors_apart", std::to_string(apart));
      // Two would fail once in twenty by chance; an engine that loses a contact in a thousand is
      // caught by the audit, step by step.
      EXPECT_LT(std::abs(apart), 5) << engine << ' ' << name << ' ' << a.value << "(" << a.error
                                    << ") against " << b.value << "(" << b.error << ")";
      EXPECT_LT(a.error, 0.1 * std::abs(a.value));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Statistics,
                         testing::Values(Point{"CD_Bagnoldian", "CD", 0.70, 50},
                                         // at 1e-2 an overlap comes near 20%, where runs end
                                         Point{"CD_Newtonian", "CD", 0.82, 1, 5e-3},
                                         Point{"CD_n_Bagnoldian", "CD_n", 0.78, 50},
                                         Point{"CD_n_dense", "CD_n", 0.835, 1},
                                         Point{"CD_rot_Bagnoldian", "CD_rot", 0.70, 1},
                                         Point{"CD_rot_Newtonian", "CD_rot", 0.82, 1}),
                         [](auto const& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace bagnold::test
