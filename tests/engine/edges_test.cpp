// SPDX-License-Identifier: BSD-3-Clause
//
// Engines driven over their edges: what happens is right, or said.
#include "src/config/errors.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

class Edges : public EverySimulation {
 public:
  /// The message with which a simulation ends within some steps; "" if it does not.
  std::string end_of(Scene const& scene, State const& state, std::int64_t steps) const {
    try {
      auto const simulation = simulate(scene, state, backend());
      advance(*simulation, steps);
    } catch (NumericalError const& error) {
      return error.what();
    }
    return {};
  }

  static void expect_words(std::string const& message, std::initializer_list<char const*> words) {
    for (auto const* word : words)
      EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
  }
};

/// The rate jumps by a thousand in between steps, velocities with it, as in a ramp of long pieces:
/// lists from the slow flow would be outrun in a step. Against all pairs, all images.
TEST_P(Edges, ASuddenRateChangeLosesNoContact) {
  Scene scene = small_scene(0.8);
  scene.shear.strain_rate = 2e-5;
  auto const slow = simulate(scene, random_start(scene).state, backend());
  advance(*slow, 300);
  State state = slow->state();
  for (auto& v : state.velocity) v = {1e3 * v[0], 1e3 * v[1]};
  for (auto& spin : state.spin) spin *= 1e3;
  scene.shear.strain_rate *= 1e3;
  auto const fast = simulate(scene, state, backend());
  reference::System oracle(reference_parameters(scene), state);
  for (int k = 0; k < 10; ++k) {
    advance(*fast, 40);
    for (int s = 0; s < 40; ++s) reference::step(oracle);
    ASSERT_LT(largest_difference(fast->state(), oracle.s, scene.shear.strain_rate), 1e-9) << k;
  }
}

/// The skin is gone in one step of the mean flow: no list can hold, and the engine says so.
TEST_P(Edges, ARateThatUsesUpTheSkinInOneStep) {
  Scene scene = small_scene(0.1);
  scene.shear.strain_rate = 0.5;
  scene.integration.time_step = 1.0;
  scene.integration.skin = 0.05;
  State const state = random_start(scene).state;
  expect_words(end_of(scene, state, 10), {"skin", "integration.time_step", "step 0"});
}

/// A time step at which a contact in a packing grows: energy is made until something gives.
TEST_P(Edges, EnergyThatGrowsIsSeen) {
  Scene scene = small_scene(0.84);
  scene.disks.elasticity = 1.0;
  scene.integration.time_step = 1.4;
  expect_words(end_of(scene, random_start(scene).state, 4000), {"integration.time_step", "disk"});
}

/// Damping so strong that a step turns disks around instead of slowing them down.
TEST_P(Edges, DampingThatReversesDisksIsSeen) {
  Scene scene = small_scene(0.84);
  scene.disks.elasticity = 0.1;
  scene.integration.time_step = 0.4;
  expect_words(end_of(scene, random_start(scene).state, 4000), {"integration.time_step", "disk"});
}

BAGNOLD_FOR_EVERY_SIMULATION(Edges);

}  // namespace bagnold::test
