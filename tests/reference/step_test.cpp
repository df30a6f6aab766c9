// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/scenes.hpp"

namespace bagnold::reference {
namespace {

class StepOfEveryModel : public OfEveryLaw {};
BAGNOLD_FOR_EVERY_LAW(StepOfEveryModel);

/// The box may be cut anywhere: moving all disks by (a, b), with gammadot b added to v_x, is only
/// another origin. Checked over steps, so that disks cross the edges at other times.
TEST_P(StepOfEveryModel, TheOriginDoesNotMatter) {
  System first(parameters(GetParam()), scattered(40, 6));
  first.p.time_step = 0.02;
  System second = first;
  for (std::size_t i = 0; i < second.s.count(); ++i) {
    second.s.position[i][0] += 1.234;
    second.s.position[i][1] += 2.345;
    second.s.velocity[i][0] += 2.345 * second.p.strain_rate;
  }
  wrap(second.p, second.s, 0.0);
  for (int n = 0; n < 200; ++n) step(first), step(second);
  Sums const a = measure(first), b = measure(second);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(a.el[0][k], b.el[0][k], 1e-11);
    EXPECT_NEAR(a.dis[0][k], b.dis[0][k], 1e-11);
    EXPECT_NEAR(a.kin[0][k], b.kin[0][k], 1e-11);
  }
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_NEAR(a.kinetic_energy, b.kinetic_energy, 1e-11);
}

/// E(T) - E(0) - integral of (sigma gammadot L^2 - dissipation) by trapezoids, contacts lasting.
double energy_gap(std::string_view law, bool area_mass, double dt) {
  Parameters p = parameters(law);
  p.area_mass = area_mass;
  p.time_step = dt;
  System system(p, packed(6, 7));
  std::size_t const pairs = contacts(system).size();
  double const area = system.s.box_length * system.s.box_length;
  auto power = [&](Sums const& s) {
    double const p_xy = s.el[0][1] + s.dis[0][1] + s.kin[0][1];
    return -p_xy * p.strain_rate * area - s.dissipation;
  };
  Sums sums = measure(system);
  double gap = -(sums.kinetic_energy + sums.elastic_energy);
  long const steps = std::lround(0.4 / dt);
  for (long n = 0; n < steps; ++n) {
    gap -= 0.5 * dt * power(sums);
    step(system);
    sums = measure(system);
    gap -= 0.5 * dt * power(sums);
    EXPECT_EQ(contacts(system).size(), pairs);
  }
  return gap + sums.kinetic_energy + sums.elastic_energy;
}

TEST_P(StepOfEveryModel, EnergyBalanceClosesAsTheSquareOfTheStep) {
  for (bool area_mass : {false, true}) {
    double const coarse = energy_gap(GetParam(), area_mass, 0.008);
    double const middle = energy_gap(GetParam(), area_mass, 0.004);
    double const fine = energy_gap(GetParam(), area_mass, 0.002);
    RecordProperty(area_mass ? "area" : "equal", std::to_string(1e6 * coarse) + " " +
                                                     std::to_string(coarse / middle) + " " +
                                                     std::to_string(middle / fine));
    EXPECT_NEAR(coarse / middle, 4.0, 0.4);
    EXPECT_NEAR(middle / fine, 4.0, 0.2);
  }
}

TEST_P(StepOfEveryModel, TrajectoriesAreOfSecondOrderInsideContacts) {
  auto end = [](double dt) {
    Parameters p = parameters(GetParam());
    p.time_step = dt;
    System system(p, packed(6, 8));
    for (long n = 0; n < std::lround(0.4 / dt); ++n) step(system);
    return system.s.velocity[14][0];
  };
  double const a = end(0.008), b = end(0.004), c = end(0.002);
  EXPECT_NEAR((a - b) / (b - c), 4.0, 0.2);
}

TEST(Step, ADiskAloneCrossesTheEdges) {
  Parameters p = parameters(Model::CD_rot);
  State s;
  s.box_length = 3.0;
  s.position = {{0.5, 2.9}};
  s.velocity = {{0.3, 0.4}};
  s.diameter = {1.0};
  System system(p, s);
  for (int n = 0; n < 1000; ++n) step(system);  // 20 up through the edge: y = 22.9, x = 15.5
  double const gamma = strain(system);
  EXPECT_NEAR(gamma, 2.5, 1e-12);
  EXPECT_NEAR(system.s.time, 50.0, 1e-12);
  EXPECT_NEAR(system.s.position[0][1], 22.9 - 7 * 3.0, 1e-11);
  EXPECT_NEAR(system.s.velocity[0][0], 0.3 - 7 * 0.05 * 3.0, 1e-12);
  // Each crossing k, at y = 3k, takes gamma L off x at its own strain; the speed then is less by
  // gammadot L per crossing: both together are one image with n = 7 at the end.
  double const x = 15.5 - 7 * gamma * 3.0;
  EXPECT_NEAR(system.s.position[0][0], x - std::floor(x / 3.0) * 3.0, 1e-10);
}

}  // namespace
}  // namespace bagnold::reference
