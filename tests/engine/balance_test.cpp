// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reference/energy.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

class Balance : public EverySimulation {};

/// Total momentum along y is conserved to rounding; along x, a wrap changes it by m gammadot L, so
/// it is checked without shear, where the third law alone decides.
TEST_P(Balance, MomentumIsConserved) {
  Scene scene = small_scene(0.84);
  State const before = shaken_start(scene);
  scene.shear.strain_rate = 0.0;
  auto const simulation = simulate(scene, before, backend());
  advance(*simulation, 500);
  State const after = simulation->state();
  auto const p = reference_parameters(scene);
  for (int axis : {0, 1}) {
    double change = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < before.count(); ++i) {
      double const m = reference::mass(p, before.diameter[i]);
      change += m * (after.velocity[i][axis] - before.velocity[i][axis]);
      scale += m * std::abs(before.velocity[i][axis]);
    }
    EXPECT_LT(std::abs(change), 1e-13 * (scale + 1)) << "axis " << axis;
  }
}

/// Two disks in contact, moving and spinning: orbital and spin angular momentum together are
/// conserved, which needs the actual arms r_ij d_i/(d_i + d_j).
TEST_P(Balance, AngularMomentumOfAPairIsConserved) {
  if (law() == "CD") GTEST_SKIP() << "CD has no spins to take up the torque of its force";
  Scene scene = small_scene();
  scene.shear.strain_rate = 0.0;
  scene.integration.skin = 0.5;
  State state;
  state.box_length = 10.0;
  state.position = {{4.0, 5.0}, {5.0, 5.6}};
  state.velocity = {{0.02, 0.05}, {-0.03, 0.01}};
  state.diameter = {1.0, 1.4};
  if (scene.rotates()) state.spin = {0.3, -0.1};

  auto const p = reference_parameters(scene);
  auto const angular_momentum = [&](State const& s) {
    double total = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      double const m = reference::mass(p, s.diameter[i]);
      total += m * (s.position[i][0] * s.velocity[i][1] - s.position[i][1] * s.velocity[i][0]);
      if (!s.spin.empty()) total += reference::moment_of_inertia(p, s.diameter[i]) * s.spin[i];
    }
    return total;
  };
  auto const drift = [&](double time_step) {
    scene.integration.time_step = time_step;
    auto const simulation = simulate(scene, state, backend());
    advance(*simulation, std::llround(1.0 / time_step));
    return std::abs(angular_momentum(simulation->state()) - angular_momentum(state));
  };
  double const coarse = drift(0.01), fine = drift(0.005);
  EXPECT_LT(coarse, 1e-5);
  if (coarse > 1e-13) {  // the trapezoid of a torque is of second order
    EXPECT_GT(coarse / fine, 3.5);
  }
}

/// Power in minus dissipation is the change of energy, d(K + V)/dt = sigma gammadot L_x L_y - D,
/// within 1% of what is lost at the papers' time step, and closing as dt^2 while contacts last.
TEST_P(Balance, EnergyIsAccountedFor) {
  struct Case {
    char const* mass;
    double aspect;
  };
  for (auto const& [mass, aspect] : {Case{"equal", 1.0}, Case{"area", 1.0}, Case{"area", 4.0}}) {
    Scene scene = small_scene(0.86);
    scene.disks.mass = mass;
    scene.disks.box_aspect = aspect;
    scene.shear.strain_rate = 1e-3;
    State start_state = random_start(scene).state;
    {
      scene.integration.time_step = 0.02;
      auto const settle = simulate(scene, start_state, backend());
      advance(*settle, 5000);
      start_state = settle->state();
    }
    auto const open_share = [&](double time_step, double duration) {
      scene.integration.time_step = time_step;
      auto const simulation = simulate(scene, start_state, backend());
      auto const p = reference_parameters(scene);
      auto const measured = [&] {
        reference::System system(p, simulation->state());
        return reference::measure(system);
      };
      double const area = start_state.box_length * start_state.box_height();
      double taken_in = 0.0, lost = 0.0;
      auto const first = measured();
      auto last = first;
      auto const steps = std::llround(duration / time_step);
      for (long long k = 0; k < steps; ++k) {
        auto const before = last;
        advance(*simulation, 1);
        last = measured();
        auto const power = [&](reference::Sums const& s) {
          return -(s.el[0][1] + s.dis[0][1] + s.kin[0][1]) * scene.shear.strain_rate * area;
        };
        taken_in += time_step / 2 * (power(before) + power(last));
        lost += time_step / 2 * (before.dissipation + last.dissipation);
      }
      double const change =
          last.kinetic_energy + last.elastic_energy - first.kinetic_energy - first.elastic_energy;
      return std::abs(taken_in - lost - change) / lost;
    };
    double const paper = std::min(paper_time_step(scene.disks), 0.05);
    EXPECT_LT(open_share(paper, 20.0), 0.01) << mass << " " << aspect;
    double const coarse = open_share(0.02, 4.0), fine = open_share(0.01, 4.0);
    EXPECT_LT(fine, 0.4 * coarse) << mass << ": " << coarse << " " << fine;
  }
}

/// What torques put into the rotation is what it gains, up to the square of the step.
TEST_P(Balance, RotationIsAccountedFor) {
  Scene scene = small_scene(0.84);
  if (!scene.rotates()) GTEST_SKIP() << "has no rotation";
  State const start_state = shaken_start(scene);
  auto const p = reference_parameters(scene);
  auto const energy = [&](State const& s) { return reference::rotation_energy(p, s); };
  auto const open_share = [&](double time_step) {
    scene.integration.time_step = time_step;
    auto const simulation = simulate(scene, start_state, backend());
    auto const sums = advance(*simulation, std::llround(20 / time_step), 1).sums;
    double const gained = energy(simulation->state()) - energy(start_state);
    return std::abs(time_step * sums[SumColumns::torque_power] - gained) /
           (time_step * sums[SumColumns::dissipation]);
  };
  double const coarse = open_share(0.02), fine = open_share(0.01);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, 0.6 * coarse);
}

BAGNOLD_FOR_EVERY_SIMULATION(Balance);

}  // namespace bagnold::test
