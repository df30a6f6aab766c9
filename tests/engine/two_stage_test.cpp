// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reference/two_stage.hpp"

#include "tests/reference/energy.hpp"
#include "tests/support/all_pairs.hpp"
#include "tests/support/few_disks.hpp"
#include "tests/support/sums.hpp"

namespace bagnold::test {

/// The two-stage leapfrog, in every engine.
class TwoStage : public EverySimulation {
 public:
  Scene two_stage_scene(double packing_fraction, std::int64_t count = 64) const {
    Scene scene = small_scene(packing_fraction, count);
    scene.integration.scheme = "two-stage-leapfrog";
    return scene;
  }
};

/// Against all pairs and all images, from the formulas: weak and strong damping, so that alpha is
/// near 1/2, well below, and at its bound.
TEST_P(TwoStage, IsThatOfTheAllPairsReference) {
  struct Case {
    double packing_fraction, elasticity, time_step;
    char const* mass;
  };
  for (auto const& [packing_fraction, elasticity, time_step, mass] :
       {Case{0.60, 20.0, 0.2, "area"}, Case{0.84, 1.0, 0.1, "equal"},
        Case{0.84, 0.2, 0.035, "area"}}) {
    Scene scene = two_stage_scene(packing_fraction);
    scene.disks.elasticity = elasticity;
    scene.disks.mass = mass;
    scene.integration.time_step = time_step;
    SCOPED_TRACE(testing::Message() << "phi " << packing_fraction << " Q " << elasticity);
    int const steps = static_cast<int>(20 / time_step);  // rounding grows with time, by collisions
    auto const simulation = expect_those_of_all_pairs(scene, shaken_start(scene), backend(), steps);
    EXPECT_GE(simulation->snapshot().list_builds, 2);
  }
}

TEST_P(TwoStage, InBoxesThatAreNotSquare) {
  for (double const aspect : {4.0, 0.25}) {
    Scene scene = two_stage_scene(0.84, 160);
    scene.disks.box_aspect = aspect;
    scene.integration.time_step = 0.1;
    SCOPED_TRACE(aspect);
    expect_those_of_all_pairs(scene, shaken_start(scene), backend(), 200);
  }
}

/// A dilute gas, evaluated at every step, against the reference engine: what windows leave out.
TEST_P(TwoStage, OfADiluteGas) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  Scene scene = two_stage_scene(0.6, 1200);
  scene.disks.elasticity = 10;
  scene.shear.strain_rate = 2e-4;
  scene.integration.skin = 0.35;
  scene.integration.time_step = 0.2;
  State state = shaken_start(scene);
  for (std::size_t i = 0; i < state.count(); ++i) {  // no common drift, and few collisions a step
    state.velocity[i][0] -=
        0.7 * (state.velocity[i][0] - scene.shear.strain_rate * state.position[i][1]);
    state.velocity[i][1] = 0.3 * (state.velocity[i][1] - 0.1);
  }
  auto const simulation = simulate(scene, state, backend());
  scene.integration.engine = "reference";
  auto const oracle = simulate(scene, state, backend_names().front());
  constexpr int steps = 700;
  auto const sums = advance(*simulation, steps, 1);
  auto const expected = advance(*oracle, steps, 1);
  EXPECT_LT(largest_difference(simulation->state(), oracle->state(), scene.shear.strain_rate),
            1e-10);
  using C = SumColumns;
  EXPECT_GE(expected.sums[C::contacts], 2400.0);
  expect_equal_sums(sums, expected);
  if (engine() == "lookahead") {
    EXPECT_GE(simulation->snapshot().counters.at("lookahead_steps"), steps / 2);
    EXPECT_GT(simulation->snapshot().counters.at("binary_islands"), 0);
  }
}

/// Several patches, in contact across every edge.
TEST_P(TwoStage, InManyPatches) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  Scene scene = two_stage_scene(0.84, 3000);
  State const state = shaken_start(scene);
  auto const simulation = simulate(scene, state, backend());
  expect_the_reference_engines(*simulation, scene, state, 150);
}

/// Where damping alone acts on a lone pair, it relaxes as the equation of motion says, at any step:
/// the tangential motion of two disks that touch without overlap force to speak of.
TEST_P(TwoStage, ALonePairRelaxesExactly) {
  if (law() == "CD_n") GTEST_SKIP() << "has no tangential damping";
  Scene scene = SlidingPair::scene(two_stage_scene(0.8));
  scene.disks.elasticity = 1.0;
  SlidingPair const pair(scene);
  auto const simulation = simulate(scene, pair.start(), backend());
  auto const sums = advance(*simulation, 1, 1).sums;
  double const z = pair.decay(), slide = pair.slide;
  EXPECT_NEAR(pair.slip(simulation->state()) / slide, std::exp(-z), 10 * pair.overlap)
      << "z " << z;  // arms are r/2, not 1/2
  // What is dissipated is what the sliding loses: (m/4) v_t^2, or (m/12) v_t^2 of what can be lost
  // with spins, beside the repulsion's work.
  double const lost = slide * slide * (1 - std::exp(-2 * z)) / (scene.rotates() ? 12 : 4);
  EXPECT_NEAR(0.4 * sums[SumColumns::dissipation], lost, 1e-4 * lost) << "z " << z;
}

/// Five disks in contact without overlap to speak of, a triangle and a chain from it: what the
/// motion of all loses in a step is what is said to be dissipated, whoever else a disk touches.
TEST_P(TwoStage, ACrowdLosesWhatIsDissipated) {
  Scene scene = two_stage_scene(0.8);
  scene.shear.strain_rate = 0.0;
  scene.disks.elasticity = 1.0;
  scene.integration.skin = 0.5;
  scene.integration.time_step = 0.4;
  State const state = crowd(scene);
  auto const p = reference_parameters(scene);
  auto const energy = [&](State const& s) { return reference::motion_energy(p, s); };
  auto const simulation = simulate(scene, state, backend());
  auto const sums = advance(*simulation, 1, 1).sums;
  EXPECT_EQ(sums[SumColumns::contacts], 10);
  double const lost = energy(state) - energy(simulation->state());
  EXPECT_GT(lost, 0.1 * energy(state));
  EXPECT_NEAR(0.4 * sums[SumColumns::dissipation], lost, 1e-5 * lost);
}

/// Summed over steps, what torques put into the rotation is what it has gained, to rounding.
TEST_P(TwoStage, TorquesPutIntoTheRotationWhatItGains) {
  Scene const scene = two_stage_scene(0.84);
  if (!scene.rotates()) GTEST_SKIP() << "has no rotation";
  State const start = shaken_start(scene);
  auto const p = reference_parameters(scene);
  auto const energy = [&](State const& s) { return reference::rotation_energy(p, s); };
  auto const simulation = simulate(scene, start, backend());
  auto const sums = advance(*simulation, 300, 1).sums;
  double const gained = energy(simulation->state()) - energy(start);
  EXPECT_NEAR(*scene.integration.time_step.number * sums[SumColumns::torque_power], gained,
              1e-10 * energy(start));
}

BAGNOLD_FOR_EVERY_SIMULATION(TwoStage);

}  // namespace bagnold::test
