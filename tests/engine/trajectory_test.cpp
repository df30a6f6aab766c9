// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/skin.hpp"
#include "tests/support/simulations.hpp"
#include "tests/support/sums.hpp"

namespace bagnold::test {

class Trajectory : public EverySimulation {};

/// Against the all-pairs reference: hundreds of steps, several list builds, disks crossing the
/// boundary in x and y. The two share no code; what is left is rounding, grown by collisions.
TEST_P(Trajectory, IsThatOfTheAllPairsReference) {
  struct Case {
    double packing_fraction, force_exponent;
    char const* mass;
  };
  for (auto const& [packing_fraction, force_exponent, mass] :
       {Case{0.60, 2.0, "area"}, Case{0.84, 2.0, "equal"}, Case{0.84, 2.5, "area"}}) {
    Scene scene = small_scene(packing_fraction);
    scene.disks.force_exponent = force_exponent;
    scene.disks.mass = mass;
    State const state = shaken_start(scene);
    auto const simulation = simulate(scene, state, backend());
    reference::System oracle(reference_parameters(scene), state);

    constexpr int steps = 400;
    int crossings = 0;
    std::vector<double> last_y(state.count());
    for (int k = 0; k < steps; ++k) {
      for (std::size_t i = 0; i < state.count(); ++i) last_y[i] = oracle.s.position[i][1];
      reference::step(oracle);
      for (std::size_t i = 0; i < state.count(); ++i)
        crossings += std::abs(oracle.s.position[i][1] - last_y[i]) > state.box_length / 2;
    }
    advance(*simulation, steps);
    EXPECT_LT(largest_difference(simulation->state(), oracle.s, scene.shear.strain_rate), 1e-12)
        << "phi " << packing_fraction << " alpha " << force_exponent << " mass " << mass;
    EXPECT_GE(simulation->snapshot().list_builds, 4);
    EXPECT_GE(crossings, 4);
    EXPECT_GE(reference::contacts(oracle).size(), packing_fraction > 0.8 ? 50u : 1u);
  }
}

/// A box just wide enough for the list, without cells.
TEST_P(Trajectory, InTheSmallestBoxes) {
  for (std::int64_t count : {12, 16, 24, 30}) {
    Scene scene = small_scene(0.80, count);
    scene.integration.skin = 0.35;
    State const state = shaken_start(scene);
    if (state.box_length < 2 * (1.4 + skin(scene))) continue;
    auto const simulation = simulate(scene, state, backend());
    reference::System oracle(reference_parameters(scene), state);
    for (int k = 0; k < 300; ++k) reference::step(oracle);
    advance(*simulation, 300);
    EXPECT_LT(largest_difference(simulation->state(), oracle.s, scene.shear.strain_rate), 1e-12)
        << count << " disks in a box of " << state.box_length;
  }
}

/// Boxes that are not square: tall ones, in which the offset runs through the width many times in a
/// strain, and flat ones.
TEST_P(Trajectory, InBoxesThatAreNotSquare) {
  for (double const aspect : {4.0, 0.25}) {
    Scene scene = small_scene(0.84, 160);
    scene.disks.box_aspect = aspect;
    State const state = shaken_start(scene);
    EXPECT_NEAR(state.box_height() / state.box_length, aspect, 1e-14);
    auto const simulation = simulate(scene, state, backend());
    reference::System oracle(reference_parameters(scene), state);
    int crossings = 0;
    for (int k = 0; k < 400; ++k) {
      State const before = oracle.s;
      reference::step(oracle);
      for (std::size_t i = 0; i < state.count(); ++i) {
        double const step = oracle.s.position[i][1] - before.position[i][1];
        crossings += std::abs(step) > state.box_height() / 2;
      }
    }
    advance(*simulation, 400);
    EXPECT_LT(largest_difference(simulation->state(), oracle.s, scene.shear.strain_rate), 1e-12)
        << aspect;
    EXPECT_NEAR(simulation->state().offset, oracle.s.offset, 1e-11);
    EXPECT_GE(crossings, 4);
    EXPECT_GE(simulation->snapshot().list_builds, 4);
  }
}

/// A dilute gas, where most disks fly free most of the time, evaluated at every step: so a contact
/// missed or too many at any step would be seen in their number.
TEST_P(Trajectory, OfADiluteGas) {
  for (std::int64_t count : {100, 2400}) {
    Scene scene = small_scene(0.6, count);
    scene.disks.elasticity = 10;
    scene.shear.strain_rate = 2e-4;
    scene.integration.skin = 0.35;
    State state = shaken_start(scene);
    for (std::size_t i = 0; i < state.count(); ++i) state.velocity[i][1] -= 0.1;  // no common drift
    auto const simulation = simulate(scene, state, backend());
    scene.integration.engine = "reference";
    auto const oracle = simulate(scene, state, backend_names().front());
    constexpr int steps = 900;
    auto const sums = advance(*simulation, steps, 1);
    auto const expected = advance(*oracle, steps, 1);
    EXPECT_LT(largest_difference(simulation->state(), oracle->state(), scene.shear.strain_rate),
              1e-10);
    ASSERT_EQ(sums.weight, expected.weight);
    using C = SumColumns;
    EXPECT_GE(expected.sums[C::contacts], 2.0 * static_cast<double>(count));
    expect_equal_sums(sums, expected);
    if (engine() == "lookahead") {
      auto const counters = simulation->snapshot().counters;
      EXPECT_GE(counters.at("lookahead_steps"), steps / 2);
      EXPECT_LT(counters.at("disks_in_larger_islands"),
                0.6 * static_cast<double>(count) * counters.at("lookaheads"));
    }
  }
}

/// Two disks of a thin gas fly at each other from where the list does not hold them, fast enough to
/// meet within the first window, and no others do.
TEST_P(Trajectory, OfDisksThatOutflyTheList) {
  Scene scene = small_scene(0.05, 16);
  scene.disks.elasticity = 50;
  scene.shear.strain_rate = 1e-4;
  scene.integration.skin = 0.35;
  State state = shaken_start(scene);
  for (std::size_t i = 0; i < state.count(); ++i)
    state.velocity[i] = {scene.shear.strain_rate * state.position[i][1], 0};
  double const contact_distance = (state.diameter[0] + state.diameter[1]) / 2;
  state.position[1] = {state.position[0][0] + contact_distance + 0.36, state.position[0][1]};
  state.velocity[0][0] += 0.06;
  state.velocity[1] = {state.velocity[0][0] - 0.12, 0};
  auto const simulation = simulate(scene, state, backend());
  scene.integration.engine = "reference";
  auto const oracle = simulate(scene, state, backend_names().front());
  auto const sums = advance(*simulation, 300, 1);
  auto const expected = advance(*oracle, 300, 1);
  using C = SumColumns;
  EXPECT_GE(expected.sums[C::contacts], 20);
  EXPECT_EQ(sums.sums[C::contacts], expected.sums[C::contacts]);
  EXPECT_LT(largest_difference(simulation->state(), oracle->state(), scene.shear.strain_rate),
            1e-11);
}

/// Thousands of disks, so that a fast engine cuts them into several patches, in contact across
/// every edge: against the reference engine, which knows no patches.
TEST_P(Trajectory, InManyPatches) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  Scene scene = small_scene(0.84, 5000);
  State const state = shaken_start(scene);
  auto const simulation = simulate(scene, state, backend());
  expect_the_reference_engines(*simulation, scene, state, 200);
  EXPECT_GE(simulation->snapshot().list_builds, 3);
}

/// The sums of a configuration against the reference's.
void expect_the_references_stresses(Scene const& scene, std::string const& backend) {
  State const state = shaken_start(scene);
  auto const simulation = simulate(scene, state, backend);
  reference::System oracle(reference_parameters(scene), state);
  for (int k = 0; k < 100; ++k) reference::step(oracle);
  advance(*simulation, 100);
  auto const window = advance(*simulation, 1, 1);
  ASSERT_EQ(window.weight, 1.0);

  auto const expected = reference::measure(oracle);
  double const area = state.box_length * state.box_height();
  double const n = static_cast<double>(state.count());
  auto const near = [&](int column, double value) {
    EXPECT_NEAR(window.sums[column], value, 1e-11 * (1 + std::abs(value))) << "column " << column;
  };
  using C = SumColumns;
  near(C::elastic_xx, expected.el[0][0] * area);
  near(C::elastic_xy, expected.el[0][1] * area);
  near(C::elastic_yy, expected.el[1][1] * area);
  near(C::dissipative_xx, expected.dis[0][0] * area);
  near(C::dissipative_xy, expected.dis[0][1] * area);
  near(C::dissipative_yx, expected.dis[1][0] * area);
  near(C::dissipative_yy, expected.dis[1][1] * area);
  near(C::dissipation, expected.dissipation);
  near(C::kinetic_xx, expected.kin[0][0] * area);
  near(C::kinetic_xy, expected.kin[0][1] * area);
  near(C::kinetic_yy, expected.kin[1][1] * area);
  near(C::contacts, 2.0 * static_cast<double>(expected.contacts));
  near(C::velocity_x2, expected.dvx2 * n);
  near(C::velocity_y2, expected.vy2 * n);
  if (scene.rotates()) {
    near(C::spin, expected.spin_mean * n * scene.shear.strain_rate);
    near(C::spin2, expected.spin2_mean * n * std::pow(scene.shear.strain_rate, 2));
  }
  if (scene.disks.model == "CD") {  // the stress of a force that is not central is not symmetric
    EXPECT_GT(std::abs(expected.dis[0][1] - expected.dis[1][0]), 1e-9);
  }
}

TEST_P(Trajectory, HasTheReferencesStresses) {
  for (double const aspect : {1.0, 4.0, 0.25}) {
    SCOPED_TRACE(aspect);
    Scene scene = small_scene(0.84);
    scene.disks.box_aspect = aspect;
    expect_the_references_stresses(scene, backend());
  }
}

BAGNOLD_FOR_EVERY_SIMULATION(Trajectory);

}  // namespace bagnold::test
