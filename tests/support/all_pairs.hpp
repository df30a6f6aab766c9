// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/scheduled_reference.hpp"

namespace bagnold::test {

/// Takes so many steps of the scene, by another scheme than the papers', and as many of all pairs
/// and images; compares the states, then the sums of one step more. Returns what has been stepped.
inline std::unique_ptr<Simulation> expect_those_of_all_pairs(Scene const& scene, State const& start,
                                                             std::string const& backend,
                                                             int steps) {
  auto const step = [&](reference::System& system, double(&dissipative)[2][2]) {
    return reference_step(system, scene.integration.scheme, dissipative);
  };
  auto simulation = simulate(scene, start, backend);
  reference::System oracle(reference_parameters(scene), start);
  double dissipative[2][2];
  for (int k = 0; k < steps; ++k) step(oracle, dissipative);
  advance(*simulation, steps);
  EXPECT_LT(largest_difference(simulation->state(), oracle.s, scene.shear.strain_rate), 1e-12);

  auto const here = reference::measure(oracle);
  EXPECT_GE(here.contacts, scene.disks.packing_fraction > 0.8 ? 50 : 1);
  auto const power = step(oracle, dissipative);
  auto const sums = advance(*simulation, 1, 1).sums;
  auto const near = [&](int column, double value) {
    EXPECT_NEAR(sums[column], value, 1e-11 * (1 + std::abs(value))) << "column " << column;
  };
  using C = SumColumns;
  double const area = start.box_length * start.box_height();
  near(C::elastic_xy, here.el[0][1] * area);
  near(C::kinetic_xy, here.kin[0][1] * area);
  near(C::contacts, 2.0 * static_cast<double>(here.contacts));
  near(C::dissipative_xx, dissipative[0][0]);
  near(C::dissipative_xy, dissipative[0][1]);
  near(C::dissipative_yx, dissipative[1][0]);
  near(C::dissipative_yy, dissipative[1][1]);
  near(C::dissipation, power.dissipation);
  if (scene.rotates()) near(C::torque_power, power.torque);
  return simulation;
}

}  // namespace bagnold::test
