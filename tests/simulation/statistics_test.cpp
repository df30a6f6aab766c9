// SPDX-License-Identifier: BSD-3-Clause
#include "src/simulation/observables.hpp"
#include "src/statistics/estimate.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A steady state, as far as a short run reaches it.
struct Point {
  char const* name;
  char const* law;
  double packing_fraction, elasticity;
};

/// Engines go one way only for so long: after some collisions their trajectories have nothing in
/// common but the statistics, which must agree.
class Statistics : public testing::TestWithParam<Point> {
 public:
  static constexpr double rate = 1e-2, warm_up = 4, strain = 24, window_strain = 0.05;

  static Scene scene() {
    Point const& p = GetParam();
    Scene scene;
    scene.disks = {p.law, 1024, p.packing_fraction, p.elasticity, "equal"};
    scene.shear.strain_rate = rate;
    scene.shear.strain = strain;
    scene.integration.time_step = 0.05;
    return scene;
  }

  static std::int64_t steps(double strain) { return std::llround(strain / (rate * 0.05)); }

  static statistics::Windows run(std::string const& engine, State const& state) {
    Scene plain = scene();
    plain.integration.engine = engine;
    auto const simulation = simulate(plain, state, backend_names().front());
    Sampling sampling{steps(window_strain), 10, steps(strain)};
    OpenWindows open;
    simulation->advance(steps(strain), sampling, open);
    statistics::Windows windows{static_cast<std::size_t>(simulation->columns()), {}, {}};
    for (auto const& window : open.sums) windows.push_back(window.sums, window.weight);
    return windows;
  }
};

TEST_P(Statistics, OfEveryEngineAreThoseOfTheReference) {
  auto const warm = simulate(scene(), random_start(scene()).state, backend_names().front());
  advance(*warm, steps(warm_up));
  State const state = warm->state();
  auto const expected = run("reference", state);
  for (std::string const engine : {"dense", "contact-rich", "windowed"}) {
    auto const found = run(engine, state);
    for (auto const& observable : observables(scene(), state.box_length)) {
      std::string const name(observable.name);
      if (name != "B_p" && name != "B_sigma" && name != "Z" && name != "R_v") continue;
      auto const a = statistics::estimate(found, 0, observable.value);
      auto const b = statistics::estimate(expected, 0, observable.value);
      ASSERT_TRUE(a.error && b.error) << a.remark << b.remark;
      double const apart = (*a.mean - *b.mean) / std::hypot(*a.error, *b.error);
      RecordProperty(engine + "_" + name + "_standard_errors_apart", std::to_string(apart));
      // Two would fail once in twenty by chance; an engine that loses a percent of its contacts is
      // caught by the audit, step by step.
      EXPECT_LT(std::abs(apart), 4) << engine << ' ' << name << ' ' << *a.mean << "(" << *a.error
                                    << ") against " << *b.mean << "(" << *b.error << ")";
      EXPECT_LT(*a.error, 0.1 * std::abs(*a.mean));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Statistics,
                         testing::Values(Point{"CD_Bagnoldian", "CD", 0.70, 50},
                                         Point{"CD_Newtonian", "CD", 0.82, 1},
                                         Point{"CD_n_Bagnoldian", "CD_n", 0.78, 50},
                                         Point{"CD_n_dense", "CD_n", 0.835, 1},
                                         Point{"CD_rot_Bagnoldian", "CD_rot", 0.70, 1},
                                         Point{"CD_rot_Newtonian", "CD_rot", 0.82, 1}),
                         [](auto const& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace bagnold::test
