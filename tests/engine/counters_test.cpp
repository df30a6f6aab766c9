// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// What a stretch of a run costs, counted.
struct Cost {
  double pairs_evaluated;  ///< a disk, an evaluation
  double touching;         ///< pairs a disk, Z/2
  double prunings;         ///< a step
  double builds;           ///< a unit of strain
  double in_lookahead;     ///< share of the steps
  double refused;          ///< share of the lookaheads
  double missed;           ///< pairs not foreseen, an island of two
};

Cost cost(Scene const& scene, double warm_up, double strain) {
  auto const simulation = simulate(scene, random_start(scene).state, backend_names().front());
  auto const steps = [&](double of) {
    return std::llround(of /
                        (scene.shear.strain_rate * scene.integration.time_step.number.value()));
  };
  advance(*simulation, steps(warm_up));
  auto const before = simulation->snapshot();
  auto const sums = advance(*simulation, steps(strain), 10);
  auto const after = simulation->snapshot();
  auto const spent = [&](char const* name) {
    return after.counters.at(name) - before.counters.at(name);
  };
  double const disks = static_cast<double>(scene.disks.count);
  double const singly = std::max(1.0, spent("steps_one_by_one"));
  double const lookaheads = std::max(1.0, spent("lookaheads"));
  return {spent("pairs_evaluated") / (2 * disks * singly),
          sums.sums[SumColumns::contacts] / sums.weight / disks / 2,
          spent("prunings") / singly,
          static_cast<double>(after.list_builds - before.list_builds) / strain,
          spent("lookahead_steps") / static_cast<double>(steps(strain)),
          spent("lookaheads_refused") / lookaheads,
          spent("pairs_missed_and_added") / std::max(1.0, spent("binary_islands"))};
}

Scene scene_of(char const* law, double packing_fraction, double elasticity, double rate) {
  Scene scene;
  scene.disks = {law, 1024, packing_fraction, elasticity, "area"};
  scene.shear.strain_rate = rate;
  scene.integration.scheme = papers_scheme;
  scene.integration.time_step = 0.05;
  return scene;
}

/// Of the pairs looked at, 3.5 a disk in the list of a plain engine at this density, hardly more
/// than those that touch are worked out.
TEST(Counters, ContactRichStepsVisitFewPairsBeyondThoseThatTouch) {
  Cost const c = cost(scene_of("CD_rot", 0.82, 1, 1e-3), 0.5, 0.2);
  EXPECT_LT(c.pairs_evaluated, 1.35 * c.touching);
  EXPECT_LT(c.prunings, 0.3);
  EXPECT_LT(c.builds, 60);
  EXPECT_EQ(c.in_lookahead, 0);
}

/// In a dilute state nearly all steps are done in lookaheads, which rarely have to be given up.
TEST(Counters, LookaheadsAreRarelyCutShort) {
  for (double const rate : {1e-4, 1e-5}) {
    Cost const c = cost(scene_of("CD_n", 0.78, 50, rate), 0.2, 0.05);
    EXPECT_GT(c.in_lookahead, 0.99) << rate;
    EXPECT_LT(c.refused, 0.01) << rate;
    EXPECT_LT(c.missed, 0.5) << rate;
    EXPECT_LT(c.builds, 150) << rate;
  }
}

}  // namespace
}  // namespace bagnold::test
