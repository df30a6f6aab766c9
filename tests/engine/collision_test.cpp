// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reference/binary_collision.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

/// Two small disks on a line, nothing else; time_step in tau_e.
class Collision : public EverySimulation {
 public:
  Scene pair_scene(double elasticity, double time_step) const {
    Scene scene = small_scene();
    scene.disks.elasticity = elasticity;
    scene.disks.damping_normal = 1.0;
    scene.shear.strain_rate = 0.0;
    scene.integration.time_step = time_step;
    scene.integration.skin = 0.5;
    return scene;
  }

  State pair(double gap, double approach) const {
    State state;
    state.box_length = 10.0;
    state.position = {{4.0, 5.0}, {5.0 + gap, 5.0}};
    state.velocity = {{approach / 2, 0.0}, {-approach / 2, 0.0}};
    if (small_scene().rotates()) state.spin = {0.0, 0.0};
    state.diameter = {1.0, 1.0};
    return state;
  }
};

/// Restitution of head-on disks against P1 Eq. (7); the scheme is of first order across the
/// opening.
TEST_P(Collision, RestitutionIsThatOfTheClosedForm) {
  for (double elasticity : {2.0, 10.0, 50.0}) {
    for (double time_step : {0.02, 0.01, 0.005}) {
      Scene const scene = pair_scene(elasticity, time_step);
      double const expected =
          reference::BinaryCollision(reference_parameters(scene), 1.0, 1.0).restitution();
      for (double phase : {0.0, 0.3, 0.6}) {  // where in a step the contact begins
        double const approach = 1e-3;
        auto const simulation =
            simulate(scene, pair(phase * approach * time_step + 1e-6, approach), backend());
        advance(*simulation, static_cast<std::int64_t>(8.0 / time_step));
        State const after = simulation->state();
        ASSERT_GT(after.position[1][0] - after.position[0][0], 1.0);
        double const restitution = (after.velocity[1][0] - after.velocity[0][0]) / approach;
        EXPECT_NEAR(restitution, expected, time_step / elasticity)
            << "Q " << elasticity << " dt " << time_step;
      }
    }
  }
}

/// Inside a lasting contact the scheme is of second order: half the step, a quarter of the error.
TEST_P(Collision, IsOfSecondOrderInsideAContact) {
  double const start_overlap = 0.05, duration = 1.0;
  auto const overlap_after = [&](double time_step) {
    Scene const scene = pair_scene(2.0, time_step);
    auto const simulation = simulate(scene, pair(-start_overlap, 0.0), backend());
    advance(*simulation, std::llround(duration / time_step));
    State const after = simulation->state();
    return 1.0 - (after.position[1][0] - after.position[0][0]);
  };
  // From rest at x_0: x = x_0 e^{-bt} (cos wt + (b/w) sin wt), b = k_d/(2 mu), w^2 = k/mu - b^2.
  double const mass = std::acos(-1.0) / 2, reduced = mass / 2;
  double const b = 0.5 / (2 * reduced), w = std::sqrt(1 / reduced - b * b);
  double const exact = start_overlap * std::exp(-b * duration) *
                       (std::cos(w * duration) + b / w * std::sin(w * duration));
  double const coarse = std::abs(overlap_after(0.02) - exact);
  double const fine = std::abs(overlap_after(0.01) - exact);
  EXPECT_GT(coarse, 1e-8);
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

BAGNOLD_FOR_EVERY_SIMULATION(Collision);

}  // namespace bagnold::test
