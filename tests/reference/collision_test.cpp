// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "tests/reference/scenes.hpp"

namespace bagnold::reference {
namespace {

/// Two disks on a line, touching, and closing in with unit relative speed, in a box of 20.
System head_on(Parameters const& p, double d_i, double d_j) {
  State s;
  s.box_length = 20.0;
  s.position = {{10.0, 10.0}, {10.0 + (d_i + d_j) / 2.0, 10.0}};
  s.velocity = {{0.005, 0.0}, {-0.005, 0.0}};
  s.diameter = {d_i, d_j};
  return System(p, s);
}

/// Relative speed after the contact over that before it.
double simulated_restitution(Parameters const& p, double d_i, double d_j) {
  System system = head_on(p, d_i, d_j);
  double const limit = 1.5 * BinaryCollision(p, d_i, d_j).duration();
  do step(system);
  while (!contacts(system).empty() && system.s.time < limit);
  return (system.s.velocity[1][0] - system.s.velocity[0][0]) / 0.01;
}

TEST(BinaryCollision, RestitutionIsThatOfThePaper) {
  Parameters p;
  p.area_mass = true;
  p.elasticity = 2.0;
  EXPECT_NEAR(BinaryCollision(p, 1.0, 1.0).restitution(), 0.3970, 5e-5);
  p.elasticity = 10.0;
  EXPECT_NEAR(BinaryCollision(p, 1.0, 1.0).restitution(), 0.8373, 5e-5);
  p.elasticity = 500.0;
  EXPECT_NEAR(BinaryCollision(p, 1.0, 1.0).restitution(), 0.9965, 5e-5);
  p.elasticity = 0.565;  // Q_d = 0.564 for two small disks
  EXPECT_GT(BinaryCollision(p, 1.0, 1.0).restitution(), 0.0);
  p.elasticity = 0.564;
  EXPECT_EQ(BinaryCollision(p, 1.0, 1.0).restitution(), 0.0);
}

/// P1 Eq. (7) as printed, for every pair and both mass rules.
TEST(BinaryCollision, RestitutionIsEquationSeven) {
  for (bool area_mass : {false, true}) {
    for (auto [d_i, d_j] : {std::pair{1.0, 1.0}, {1.0, 1.4}, {1.4, 1.4}}) {
      for (double Q : {1.5, 7.0, 80.0}) {
        Parameters p;
        p.area_mass = area_mass;
        p.elasticity = Q;
        double const m_i = mass(p, d_i), m_j = mass(p, d_j);
        double const d_ij = (d_i + d_j) / 2.0;
        double const square = 4.0 * m_i * m_j / (m_i + m_j) * Q * Q / (d_ij * d_ij);
        EXPECT_NEAR(BinaryCollision(p, d_i, d_j).restitution(),
                    std::exp(-3.14159265358979323846 / std::sqrt(square - 1.0)), 1e-14);
      }
    }
  }
}

/// The force jumps by k_d v where a contact opens, so that the step is of first order there.
TEST(BinaryCollision, SimulationGivesTheSameRestitution) {
  for (auto const law : model_names()) {
    for (bool area_mass : {false, true}) {
      for (double Q : {2.0, 10.0}) {
        Parameters p = parameters(law, Q);
        p.damping_normal = 1.0;
        p.strain_rate = 0.0;
        p.area_mass = area_mass;
        double const expected = BinaryCollision(p, 1.0, 1.4).restitution();
        for (double dt : {1e-2, 1e-3}) {
          p.time_step = dt;
          double const found = simulated_restitution(p, 1.0, 1.4);
          EXPECT_NEAR(found, expected, dt / Q);
        }
      }
    }
  }
}

TEST(BinaryCollision, OverlapFollowsTheClosedForm) {
  for (double Q : {5.0, 0.6, 0.3}) {  // equal masses, d_ij = 1.2: critical at Q = 0.6 sqrt(2)
    Parameters p;
    p.elasticity = Q == 0.6 ? 0.6 * std::sqrt(2.0) : Q;
    p.time_step = 1e-3;
    System system = head_on(p, 1.0, 1.4);
    BinaryCollision const closed(p, 1.0, 1.4);
    for (int n = 0; n < 2000; ++n) {
      step(system);
      double const separation = system.s.position[1][0] - system.s.position[0][0];
      ASSERT_NEAR(1.2 - separation, closed.overlap(0.01, system.s.time), 2e-8) << "Q = " << Q;
    }
  }
}

TEST(BinaryCollision, TheThreeFormsMeetAtCriticalDamping) {
  Parameters p;
  double const critical = std::sqrt(0.5);  // m_ij = 1/2, d_ij = 1: P1, below Eq. (7)
  auto overlap = [&](double Q) {
    p.elasticity = Q;
    return BinaryCollision(p, 1.0, 1.0).overlap(0.01, 1.7);
  };
  EXPECT_NEAR(overlap(critical * (1 + 1e-8)), overlap(critical), 1e-9);
  EXPECT_NEAR(overlap(critical * (1 - 1e-8)), overlap(critical), 1e-9);
  p.elasticity = 0.1;
  EXPECT_GT(BinaryCollision(p, 1.0, 1.0).overlap(0.01, 300.0), 0.0);
}

/// A dense sheared run: over strain 4, work in = dissipation + change of energy within 1% at the
/// papers' step, and disks turn at -gammadot/2 on average (P2, Fig. 20a).
TEST(ShearedReference, PowerBalanceAndMeanSpin) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Parameters p;
  p.model = Model::CD_rot;
  p.elasticity = 1.0;
  p.strain_rate = 0.01;
  State s;
  s.box_length = std::sqrt(1.1624 * 32 / 0.84);
  for (int i = 0; i < 32; ++i) {
    double const y = s.box_length * unit(random);
    s.position.push_back({s.box_length * unit(random), y});
    s.velocity.push_back({p.strain_rate * y, 0.0});
    s.diameter.push_back(i % 2 == 0 ? 1.0 : 1.4);
  }
  System system(p, s);
  for (int n = 0; n < 2000; ++n) step(system);  // the random start comes apart
  double const area = s.box_length * s.box_length;
  Sums sums = measure(system);
  double const energy = sums.kinetic_energy + sums.elastic_energy;
  double work = 0.0, loss = 0.0, spin = 0.0;
  int const steps = 8000;
  for (int n = 0; n < steps; ++n) {
    step(system);
    sums = measure(system);
    work -= (sums.el[0][1] + sums.dis[0][1] + sums.kin[0][1]) * p.strain_rate * area * p.time_step;
    loss += sums.dissipation * p.time_step;
    spin += sums.spin_mean / steps;
  }
  double const gain = sums.kinetic_energy + sums.elastic_energy - energy;
  RecordProperty("gap", std::to_string((work - loss - gain) / work));
  RecordProperty("spin", std::to_string(spin));
  EXPECT_NEAR((work - loss - gain) / work, 0.0, 0.01);
  EXPECT_NEAR(spin, -0.5, 0.05);
}

}  // namespace
}  // namespace bagnold::reference
