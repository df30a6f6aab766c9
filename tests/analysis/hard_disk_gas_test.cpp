// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

namespace bagnold::analysis {
namespace {

/// p / (n T) of a gas of hard disks in equal numbers of diameters 1 and 1.4,
///
///     p/(n T) = 1 + (pi/2) n sum_ij x_i x_j d_ij^2 g_ij,
///     g_ij = 1/(1 - phi) + (9/16) phi/(1 - phi)^2 (d_i d_j/d_ij) <d>/<d^2>,
///
/// d_ij = (d_i + d_j)/2, n = 4 phi / (pi <d^2>): Jenkins and Mancini, J. Appl. Mech. 54, 27 (1987);
/// Santos, Yuste and Lopez de Haro, Mol. Phys. 96, 1 (1999) have the same with Henderson's g.
double compressibility(double phi) {
  double const diameters[] = {1.0, 1.4}, mean = 1.2, mean2 = 1.48;
  double sum = 0.0;
  for (double const a : diameters)
    for (double const b : diameters) {
      double const middle = (a + b) / 2.0;
      double const g = 1.0 / (1.0 - phi) + 9.0 / 16.0 * phi / ((1.0 - phi) * (1.0 - phi)) * a * b /
                                               middle * mean / mean2;
      sum += middle * middle * g / 4.0;
    }
  double const density = 4.0 * phi / (std::numbers::pi * mean2);
  return 1.0 + std::numbers::pi / 2.0 * density * sum;
}

/// The kinetic share of the pressure, p_kin/p = n T_g/p, that docs/figures.md gives for P1 Fig. 4a.
TEST(HardDiskGas, HasTheKineticShareOfNearlyElasticDisks) {
  EXPECT_NEAR(1.0 / compressibility(0.60), 0.1557, 5e-5);
  EXPECT_NEAR(compressibility(1e-6), 1.0, 1e-5);  // an ideal gas
}

}  // namespace
}  // namespace bagnold::analysis
