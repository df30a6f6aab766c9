// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reference/implicit.hpp"

#include "tests/reference/energy.hpp"
#include "tests/support/all_pairs.hpp"
#include "tests/support/few_disks.hpp"

namespace bagnold::test {
namespace {

int iterations(Scene const& scene) { return reference::chebyshev_iterations(scene.rotates()); }

}  // namespace

/// The leapfrog with implicit damping, in the engines that step all disks.
class Implicit : public EverySimulation {
 public:
  Scene implicit_scene(double packing_fraction, std::int64_t count = 64) const {
    Scene scene = small_scene(packing_fraction, count);
    scene.integration.scheme = ImplicitDamping::name;
    scene.integration.skin = 0.35;
    scene.disks.elasticity = 1.0;
    scene.shear.strain_rate = 1e-3;
    scene.integration.time_step = 0.8;
    return scene;
  }

  /// As shaken_start(), slower: long steps are for flows that creep.
  static State creeping_start(Scene const& scene) {
    State state = shaken_start(scene);
    for (std::size_t i = 0; i < state.count(); ++i) {
      double const flow = scene.shear.strain_rate * state.position[i][1];
      auto& v = state.velocity[i];
      v = {flow + 0.1 * (v[0] - flow), 0.1 * v[1]};
      if (!state.spin.empty()) state.spin[i] *= 0.1;
    }
    return state;
  }

  static auto all() {
    return testing::Combine(testing::ValuesIn(law_names()), testing::ValuesIn(backend_names()),
                            testing::Values("reference", "many-contacts"));
  }
};

/// Against all pairs and all images, from the formulas: weak and strong damping.
TEST_P(Implicit, IsThatOfTheAllPairsReference) {
  struct Case {
    double packing_fraction, elasticity, time_step;
    char const* mass;
  };
  for (auto const& [packing_fraction, elasticity, time_step, mass] :
       {Case{0.60, 20.0, 0.2, "area"}, Case{0.84, 1.0, 0.8, "equal"},
        Case{0.84, 0.2, 2.0, "area"}}) {
    Scene scene = implicit_scene(packing_fraction);
    scene.disks.elasticity = elasticity;
    scene.disks.mass = mass;
    scene.integration.time_step = time_step;
    SCOPED_TRACE(testing::Message() << "phi " << packing_fraction << " Q " << elasticity);
    int const steps = static_cast<int>(20 / time_step);  // rounding grows with time, by collisions
    expect_those_of_all_pairs(scene, creeping_start(scene), backend(), steps);
  }
}

TEST_P(Implicit, InBoxesThatAreNotSquare) {
  for (double const aspect : {4.0, 0.25}) {
    Scene scene = implicit_scene(0.84, 160);
    scene.disks.box_aspect = aspect;
    SCOPED_TRACE(aspect);
    expect_those_of_all_pairs(scene, creeping_start(scene), backend(), 25);
  }
}

/// Several patches, in contact across every edge.
TEST_P(Implicit, InManyPatches) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  Scene scene = implicit_scene(0.84, 3000);
  State const state = creeping_start(scene);
  auto const simulation = simulate(scene, state, backend());
  expect_the_reference_engines(*simulation, scene, state, 20);
}

/// A pair that slides without overlap to speak of: two stages of damping and any other scheme would
/// do no better than 1/(1 + z), which n iterations give to what they leave.
TEST_P(Implicit, ALonePairSlidesAsTheEquationSays) {
  if (law() == "CD_n") GTEST_SKIP() << "has no tangential damping";
  Scene const scene = SlidingPair::scene(implicit_scene(0.8));
  SlidingPair const pair(scene);
  auto const simulation = simulate(scene, pair.start(), backend());
  advance(*simulation, 1, 1);
  double const k = pair.tangential, z = pair.decay();
  double const largest = law() == "CD_nt" ? std::max(k, scene.disks.damping_normal) : k;
  double const bound = pair.time_step * 2 * largest * (scene.rotates() ? 3 : 1);
  double const error = reference::left_at_most(iterations(scene), bound);
  EXPECT_NEAR(pair.slip(simulation->state()) / pair.slide, 1 / (1 + z),
              z * error + 10 * pair.overlap)
      << "z " << z;
}

/// Five disks in contact without overlap to speak of: what the motion of all loses in a step is
/// what is said to be dissipated, and their momentum stays.
TEST_P(Implicit, ACrowdLosesWhatIsDissipated) {
  Scene scene = implicit_scene(0.8);
  scene.shear.strain_rate = 0.0;
  scene.integration.skin = 0.5;
  State const state = crowd(scene);
  auto const p = reference_parameters(scene);
  auto const simulation = simulate(scene, state, backend());
  auto const sums = advance(*simulation, 1, 1).sums;
  State const after = simulation->state();
  EXPECT_EQ(sums[SumColumns::contacts], 10);
  double const lost = reference::motion_energy(p, state) - reference::motion_energy(p, after);
  EXPECT_GT(lost, 0.1 * reference::motion_energy(p, state));
  EXPECT_NEAR(0.8 * sums[SumColumns::dissipation], lost, 1e-5 * lost);
  for (int a = 0; a < 2; ++a) {
    double change = 0;
    for (std::size_t i = 0; i < state.count(); ++i)
      change +=
          reference::mass(p, state.diameter[i]) * (after.velocity[i][a] - state.velocity[i][a]);
    EXPECT_NEAR(change, 0, 1e-17);
  }
}

/// Summed over steps, what torques put into the rotation is what it has gained, to rounding.
TEST_P(Implicit, TorquesPutIntoTheRotationWhatItGains) {
  Scene const scene = implicit_scene(0.84);
  if (!scene.rotates()) GTEST_SKIP() << "has no rotation";
  State const start = creeping_start(scene);
  auto const p = reference_parameters(scene);
  auto const energy = [&](State const& s) { return reference::rotation_energy(p, s); };
  auto const simulation = simulate(scene, start, backend());
  auto const sums = advance(*simulation, 60, 1).sums;
  double const gained = energy(simulation->state()) - energy(start);
  EXPECT_NEAR(*scene.integration.time_step.number * sums[SumColumns::torque_power], gained,
              1e-10 * energy(start));
}

/// What the iterations leave is within the bound of their polynomial, so the eigenvalues are within
/// theirs; and a step solved to rounding is near.
TEST_P(Implicit, IterationsConverge) {
  if (engine() != "reference" || backend() != backend_names().front())
    GTEST_SKIP() << "of the reference code";
  for (double const packing_fraction : {0.6, 0.8, 0.84}) {
    Scene scene = implicit_scene(packing_fraction, 100);
    scene.integration.time_step = 1.2;
    State const state = creeping_start(scene);
    reference::System solved(reference_parameters(scene), state), system = solved;
    double dissipative[2][2];
    double most = 0;
    for (int k = 0; k < 40; ++k) {
      auto const power = reference::implicit_step(system, iterations(scene), dissipative);
      EXPECT_LE(power.left, power.allowed);
      most = std::max(most, power.left);
    }
    EXPECT_GT(most, 1e-3);
    reference::implicit_step(solved, 0, dissipative);
    reference::System iterated(reference_parameters(scene), state);
    reference::implicit_step(iterated, 12 * iterations(scene), dissipative);
    EXPECT_LT(largest_difference(solved.s, iterated.s, scene.shear.strain_rate), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Implicit, Implicit::all(), Implicit::name);

}  // namespace bagnold::test
