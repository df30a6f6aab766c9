// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces with a strain rate of any sign or none, in every engine: reversals, stops, oscillations.
#include "kernels/physics/type_list.hpp"
#include "src/config/strain_rates.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/scheduled_reference.hpp"

namespace bagnold::test {

class Pieces : public EverySimulation {
 public:
  Scene sequence_scene(double packing_fraction, std::string_view scheme) const {
    Scene scene = small_scene(packing_fraction, 64);
    scene.start.kind = "state";
    scene.integration.scheme = scheme;
    scene.integration.skin = 0.35;
    scene.shear.protocol = "sequence";
    scene.shear.pieces = {{1e-2, 0.1}, {-1e-2, 0.1}, {0, 2.5}, {2e-2, 0.05}, {-5e-3, 0.01}};
    return scene;
  }
};

TEST_P(Pieces, AreThoseOfTheAllPairsReference) {
  if (backend() != backend_names().front()) GTEST_SKIP() << "see DoNotDependOnTheBackend";
  for (auto const scheme : names_of<Schemes>()) {
    SCOPED_TRACE(scheme);
    for (double const packing_fraction : {0.60, 0.84}) {
      if (packing_fraction < 0.8 && scheme != DefaultScheme::name) continue;
      Scene const scene = sequence_scene(packing_fraction, scheme);
      auto const pieces = pieces_of(scene).value();
      State const state = shaken_start(scene);
      auto const simulation = simulate(scene, state, backend());
      ScheduledReference oracle(scene, state);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        auto const stop = pieces[k].begin + pieces.steps_of(k);
        while (oracle.system().step < stop) oracle.step();
        advance(*simulation, stop - simulation->step());
        double const rate = oracle.system().p.strain_rate;
        EXPECT_EQ(simulation->state().strain_rate, rate);
        EXPECT_LT(largest_difference(simulation->state(), oracle.system().s, rate), 1e-11)
            << "phi " << packing_fraction << " piece " << k;
      }
      EXPECT_GE(simulation->snapshot().list_builds, 2);
      EXPECT_GE(reference::contacts(oracle.system()).size(), packing_fraction > 0.8 ? 50u : 1u);
    }
  }
}

/// The state comes back to its strain, and total momentum to zero, whatever was between.
TEST_P(Pieces, KeepMomentumAndReturnToTheirStrain) {
  Scene scene = sequence_scene(0.84, DefaultScheme::name);
  scene.shear.pieces = {{1e-2, 0.1}, {0, 5}, {-1e-2, 0.1}};
  State const state = random_start(scene).state;
  auto const simulation = simulate(scene, state, backend());
  advance(*simulation, pieces_of(scene)->steps());
  State const end = simulation->state();
  double const turns = (end.offset - state.offset) / end.box_length;
  EXPECT_NEAR(turns, std::round(turns), 1e-12);
  double momentum[2] = {0, 0}, speed = 0;
  for (std::size_t i = 0; i < end.count(); ++i) {
    Vec2<Real> const excess{end.velocity[i][0] - end.strain_rate.value() * end.position[i][1],
                            end.velocity[i][1]};
    double const mass = end.diameter[i] * end.diameter[i];  // by area, over that of a small disk
    momentum[0] += mass * excess.x;
    momentum[1] += mass * excess.y;
    speed += std::hypot(excess.x, excess.y);
  }
  EXPECT_GT(speed, 1e-3);
  EXPECT_LT(std::hypot(momentum[0], momentum[1]), 1e-12 * speed);
}

/// An oscillation that is cut, snapshot and continued has the bits of one that was not.
TEST_P(Pieces, GoOnFromASnapshot) {
  for (auto const scheme : names_of<Schemes>()) {
    SCOPED_TRACE(scheme);
    Scene scene = sequence_scene(0.84, scheme);
    scene.shear.protocol = "oscillate";
    scene.shear.amplitude = 0.02;
    scene.shear.period = 20;
    scene.shear.cycle_pieces = 16;
    scene.shear.cycles = 2;
    auto const steps = pieces_of(scene)->steps();
    State const state = shaken_start(scene);
    auto const whole = simulate(scene, state, backend());
    advance(*whole, steps);
    auto cut = simulate(scene, state, backend());
    for (std::int64_t step = 0; step < steps; step += 37) {
      advance(*cut, std::min<std::int64_t>(37, steps - step));
      cut = make_simulation(scene, cut->snapshot(), backend());
    }
    EXPECT_EQ(cut->state().position, whole->state().position);
    EXPECT_EQ(cut->state().velocity, whole->state().velocity);
    EXPECT_EQ(cut->state().spin, whole->state().spin);
    EXPECT_NEAR(whole->state().offset, state.offset, 1e-15);
  }
}

BAGNOLD_FOR_EVERY_SIMULATION(Pieces);

}  // namespace bagnold::test
