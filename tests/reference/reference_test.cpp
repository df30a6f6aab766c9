// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/scenes.hpp"

namespace bagnold::reference {
namespace {

double largest_difference(std::vector<std::array<double, 3>> const& a,
                          std::vector<std::array<double, 3>> const& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
  }
  return largest;
}

class EveryModel : public OfEveryLaw {};
BAGNOLD_FOR_EVERY_LAW(EveryModel);

TEST_P(EveryModel, ForcesAddUpToNothing) {
  Parameters p = parameters(GetParam());
  for (double alpha : force_exponents()) {
    p.force_exponent = alpha;
    auto const f = forces_and_torques(p, scattered(80, 1), 0.37);
    double x = 0.0, y = 0.0;
    for (auto const& row : f) x += row[0], y += row[1];
    EXPECT_NEAR(x, 0.0, 1e-12);
    EXPECT_NEAR(y, 0.0, 1e-12);
  }
}

/// sum tau_i = -sum r_ij x f_ij = L^2 (p_xy - p_yx): what makes p^dis asymmetric is angular
/// momentum that goes to the spins. In model CD it goes nowhere, hence no torque to compare with.
TEST_P(EveryModel, TorquesBalanceTheAsymmetryOfTheStress) {
  System system(parameters(GetParam()), scattered(80, 2));
  if (system.p.model == Model::CD)
    GTEST_SKIP() << "angular momentum is not conserved without spins";
  double torque = 0.0;
  for (auto const& row : forces_and_torques(system.p, system.s, strain(system))) torque += row[2];
  Sums const sums = measure(system);
  double const area = system.s.box_length * system.s.box_length;
  EXPECT_NEAR(torque, area * (sums.dis[0][1] - sums.dis[1][0]), 1e-12);
  EXPECT_NEAR(sums.el[0][1], sums.el[1][0], 1e-14);
  if (system.p.model != Model::CD_n) {
    EXPECT_GT(std::abs(torque), 0.1);
  }
}

TEST_P(EveryModel, AlphaFollowsFromThePotential) {
  System system(parameters(GetParam(), 1e300), scattered(60, 3));  // no damping
  for (double alpha : force_exponents()) {
    system.p.force_exponent = alpha;
    auto const f = forces_and_torques(system.p, system.s, 0.0);
    double const h = 1e-6;
    for (std::size_t i : {0u, 7u, 30u}) {
      for (int a = 0; a < 2; ++a) {
        System up = system, down = system;
        up.s.position[i][a] += h;
        down.s.position[i][a] -= h;
        double const slope = (measure(up).elastic_energy - measure(down).elastic_energy) / (2 * h);
        EXPECT_NEAR(f[i][a], -slope, 1e-8);
      }
    }
  }
}

TEST_P(EveryModel, StrainPlusOneIsTheSameStrain) {
  Parameters const p = parameters(GetParam());
  State const s = scattered(80, 4);
  EXPECT_LT(largest_difference(forces_and_torques(p, s, 0.37), forces_and_torques(p, s, 1.37)),
            1e-12);
  EXPECT_LT(largest_difference(forces_and_torques(p, s, 0.37), forces_and_torques(p, s, -2.63)),
            1e-12);
}

TEST_P(EveryModel, AnotherImageOfADiskIsTheSameDisk) {
  Parameters const p = parameters(GetParam());
  State const s = scattered(80, 5);
  double const gamma = 0.37;
  auto const f = forces_and_torques(p, s, gamma);
  for (int n = -1; n <= 1; ++n) {
    for (int m = -1; m <= 1; ++m) {
      State other = s;
      for (std::size_t i = 0; i < s.count(); i += 3) {
        other.position[i][0] += (m + n * gamma) * s.box_length;
        other.position[i][1] += n * s.box_length;
        other.velocity[i][0] += n * p.strain_rate * s.box_length;
      }
      EXPECT_LT(largest_difference(f, forces_and_torques(p, other, gamma)), 1e-12);
      wrap(p, other, gamma);
      for (std::size_t i = 0; i < s.count(); ++i) {
        EXPECT_NEAR(other.position[i][0], s.position[i][0], 1e-13);
        EXPECT_NEAR(other.position[i][1], s.position[i][1], 1e-13);
        EXPECT_NEAR(other.velocity[i][0], s.velocity[i][0], 1e-13);
      }
    }
  }
}

/// What it has no formula of it refuses, and says its name; other linear laws are one of its forms.
TEST(Reference, RefusesByNameALawThatItHasNot) {
  Parameters p;
  auto const refused = [&](std::optional<LinearLaw> const& law) {
    try {
      set_law(p, "creep", law);
      return false;
    } catch (NoFormula const& error) {
      EXPECT_NE(std::string(error.what()).find("\"creep\""), std::string::npos) << error.what();
      return true;
    }
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused(LinearLaw{false, 0.5, 0.2}));
  EXPECT_FALSE(refused(LinearLaw{false, 0.5, 0.0}));
  EXPECT_EQ(p.model, Model::CD_n);
  EXPECT_EQ(p.elasticity, 2.0);
  EXPECT_FALSE(refused(LinearLaw{false, 0.25, 0.25}));
  EXPECT_EQ(p.model, Model::CD);
  EXPECT_EQ(p.elasticity, 4.0);
  EXPECT_FALSE(refused(LinearLaw{true, 0.5, 0.125}));
  EXPECT_EQ(p.model, Model::CD_nt);
  EXPECT_EQ(p.damping_normal, 2.0);
  EXPECT_EQ(p.damping_tangential, 0.5);
}

TEST(Reference, GeneralLawEndsInCDnAndCDrot) {
  State const s = scattered(80, 9);
  Parameters general = parameters(Model::CD_nt);
  general.damping_normal = 1.0;
  general.damping_tangential = 0.0;
  EXPECT_LT(largest_difference(forces_and_torques(general, s, 0.2),
                               forces_and_torques(parameters(Model::CD_n), s, 0.2)),
            1e-14);
  general.damping_tangential = 1.0;
  EXPECT_LT(largest_difference(forces_and_torques(general, s, 0.2),
                               forces_and_torques(parameters(Model::CD_rot), s, 0.2)),
            1e-14);
}

/// Numbers by hand: disk 1 (d = 1.4) touches from above the edge y = 0 disk 0 (d = 1), L = 10,
/// gamma = 0.25, gammadot = 0.1, Q = 2. Image of disk 1: (5.0, -0.6), v = (0.3 - 1, 0). Hence
/// r_ij = (0, 0.9), v_ij = (0.8, 0.2), d_ij = 1.2: elastic (0, 0.25 / 1.2); s_ji = (0, -0.375),
/// s_ij = (0, 0.525), v^C = v_ij + (0.4 * 0.375 + 0.2 * 0.525, 0) = (1.055, 0.2).
TEST(Reference, TwoDisksAcrossTheSlidingEdgeByHand) {
  State s;
  s.box_length = 10.0;
  s.position = {{5.0, 0.3}, {7.5, 9.4}};
  s.velocity = {{0.1, 0.2}, {0.3, 0.0}};
  s.spin = {0.4, 0.2};
  s.diameter = {1.0, 1.4};
  auto expect = [&](Model model, std::array<double, 3> first, double second_torque) {
    Parameters p = parameters(model);
    p.strain_rate = 0.1;
    auto const f = forces_and_torques(p, s, 0.25);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(f[0][k], first[k], 1e-14);
    EXPECT_NEAR(f[1][0], -first[0], 1e-14);
    EXPECT_NEAR(f[1][1], -first[1], 1e-14);
    EXPECT_NEAR(f[1][2], second_torque, 1e-14);
  };
  double const elastic = 0.25 / 1.2;
  expect(Model::CD, {-0.4, elastic - 0.1, 0.0}, 0.0);
  expect(Model::CD_n, {0.0, elastic - 0.1, 0.0}, 0.0);
  double const tangential = -0.5 * 1.055;
  // tau_i = s_y-arm: s x f = -s_y f_x, with s_ji,y = -0.375 on i; s_ij,y = 0.525, f_ji on j.
  expect(Model::CD_rot, {tangential, elastic - 0.1, 0.375 * tangential}, 0.525 * tangential);
  expect(Model::CD_nt, {1.6 * tangential, elastic - 0.07, 0.375 * 1.6 * tangential},
         0.525 * 1.6 * tangential);
}

}  // namespace
}  // namespace bagnold::reference
