// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/auto_scheme/scheme_choice.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "src/engine/engine_memory.hpp"

namespace bagnold {
namespace {

constexpr double strain_rate = 1e-4, stretch_strain = 0.4;

/// Sums of `weight` configurations with p_kin/p and an energy gap as given.
WindowSums sampled(double kinetic_share, double gap = 0, double weight = 16) {
  using C = SumColumns;
  WindowSums sums{std::vector<double>(C::count), weight};
  double const pressure = 2000 * weight, stress = 300 * weight;
  sums.sums[C::kinetic_xx] = sums.sums[C::kinetic_yy] = kinetic_share * pressure / 2;
  sums.sums[C::elastic_xx] = sums.sums[C::elastic_yy] = (1 - kinetic_share) * pressure / 2;
  sums.sums[C::elastic_xy] = -0.6 * stress;
  sums.sums[C::dissipative_xy] = -0.3 * stress;
  sums.sums[C::kinetic_xy] = -0.1 * stress;
  sums.sums[C::dissipation] = (1 - gap) * stress * strain_rate;
  return sums;
}

bool keeps(SchemeChoice& choice, double kinetic_share, double gap = 0) {
  return choice.keeps(sampled(kinetic_share, gap), stretch_strain, strain_rate);
}

/// Stretches that two stages take before implicit damping is tried again.
std::int64_t pause_of(SchemeChoice& choice) {
  std::int64_t stretches = 0;
  for (; !choice.implicit(); ++stretches) choice.explicit_stretch_done();
  return stretches;
}

TEST(SchemeChoice, BeginsWithTwoStages) {
  SchemeChoice choice;
  EXPECT_EQ(pause_of(choice), 1);
}

TEST(SchemeChoice, PausesGrowWithFailuresInARow) {
  SchemeChoice choice;
  pause_of(choice);
  for (std::int64_t expected = 1; expected < 5000; expected *= 2) {
    EXPECT_FALSE(keeps(choice, 1.01e-4));
    EXPECT_EQ(pause_of(choice), std::min(expected, SchemeChoice::longest_pause));
  }
  EXPECT_TRUE(keeps(choice, 0.99e-4));
  EXPECT_TRUE(choice.implicit());
  EXPECT_FALSE(keeps(choice, 1.01e-4));
  EXPECT_EQ(pause_of(choice), 1);
}

TEST(SchemeChoice, LooksAtTheEnergyGapOverLongStrains) {
  for (double const gap : {0.011, -0.011}) {
    SchemeChoice choice;
    pause_of(choice);
    for (int k = 0; k < 4; ++k) EXPECT_TRUE(keeps(choice, 1e-5, gap)) << k;  // strain 1.6
    EXPECT_FALSE(keeps(choice, 1e-5, gap));
  }
  SchemeChoice choice;
  pause_of(choice);
  for (int k = 0; k < 50; ++k)  // of five -0.003 or 0.008
    EXPECT_TRUE(keeps(choice, 1e-5, k % 2 ? 0.03 : -0.025)) << k;
}

TEST(SchemeChoice, KeepsNothingWithoutPressureOrSamples) {
  SchemeChoice choice;
  EXPECT_FALSE(keeps(choice, NAN));
  EXPECT_FALSE(choice.keeps({std::vector<double>(SumColumns::count), 16}, 0.1, strain_rate));
  EXPECT_FALSE(choice.keeps({}, 0.1, strain_rate));
}

TEST(SchemeChoice, GoesOnFromItsMemory) {
  SchemeChoice choice;
  pause_of(choice);
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(keeps(choice, 1e-3));
    pause_of(choice);
  }
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(keeps(choice, 1e-5, 0.02));
  std::map<std::string, double> memory;
  choice.for_each_memory(WriteDown{memory});
  SchemeChoice other;
  other.for_each_memory(RestoreMemory{memory});
  EXPECT_TRUE(other.implicit());
  EXPECT_TRUE(keeps(other, 1e-5, 0.02));
  EXPECT_FALSE(keeps(other, 1e-5, 0.02)) << "a strain of 2 in all";
  EXPECT_EQ(pause_of(other), 1);
}

}  // namespace
}  // namespace bagnold
