// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bagnold {
namespace {

constexpr std::int64_t trillion = 1'000'000'000'000;

/// gammadot dt = 15 / 2^22 and L = 35, exactly: strain and offset are integers over 2^22.
constexpr Clock dyadic{3.0 / (1 << 15), 5.0 / (1 << 7), 35.0, 7.0, 2.5};

double exact_offset(std::int64_t step, std::int64_t build) {
  std::int64_t const turn = std::int64_t{1} << 22;  // times L
  std::int64_t const at_build = build % turn * 15 % turn;
  // 7 / 35 of a turn more, in fifths of 1/2^22
  std::int64_t const fifths = (5 * at_build + turn) % (5 * turn);
  std::int64_t const now = fifths + 5 * 15 * (step - build);
  return static_cast<double>(static_cast<long double>(now) * 35.0L / (5.0L * turn));
}

TEST(Clock, StrainIsExactWhereTheStepsStrainIs) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 1000; ++k) {
    std::int64_t const step = static_cast<std::int64_t>(random() % trillion);
    EXPECT_EQ(dyadic.strain(step), static_cast<double>(step * 15) / (1 << 22));
    EXPECT_EQ(dyadic.time(step), 2.5 + static_cast<double>(step * 5) / (1 << 7));
  }
  EXPECT_EQ(dyadic.strain(0), 0.0);
  EXPECT_EQ(dyadic.time(0), 2.5);
  EXPECT_EQ(dyadic.strain_between(trillion - 3, trillion), 45.0 / (1 << 22));
}

TEST(Clock, OffsetIsThatOfIntegers) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 10000; ++k) {
    std::int64_t const build = static_cast<std::int64_t>(random() % trillion);
    std::int64_t const step = build + static_cast<std::int64_t>(random() % 100000);
    // the strain up to the build is up to 3.6e6 turns; 2^-64 of that is 2e-13, times L
    EXPECT_NEAR(dyadic.offset(step, build), exact_offset(step, build), 1e-11)
        << step << " " << build;
  }
}

/// gamma L_y of a box of another aspect is that of a square one under so much more strain: the same
/// bits for powers of two.
TEST(Clock, OffsetGoesByTheHeight) {
  std::mt19937_64 random(6);
  for (double const aspect : {4.0, 0.25}) {
    Clock const clock{1e-4, 0.05, 38.6, 12.3, 0.0, aspect};
    Clock const square{1e-4 * aspect, 0.05, 38.6, 12.3, 0.0};
    for (int k = 0; k < 1000; ++k) {
      std::int64_t const build = static_cast<std::int64_t>(random() % trillion);
      std::int64_t const step = build + static_cast<std::int64_t>(random() % 100000);
      EXPECT_EQ(clock.offset(step, build), square.offset(step, build)) << step << " " << build;
      EXPECT_EQ(clock.box(step, build).offset, square.offset(step, build));
    }
    EXPECT_EQ(clock.strain(1000), (Clock{1e-4, 0.05, 38.6, 12.3, 0.0}.strain(1000)));
    EXPECT_EQ(clock.box(0, 0).height, aspect * 38.6);
  }
}

TEST(Clock, StrainDoesNotDriftOverATrillionSteps) {
  Clock const clock{1e-4, 0.05, 38.6, 0.0, 0.0};
  // 1e-4 and 0.05 as doubles, times 1e12; what they differ from decimals by is 1e-17 of them
  long double const exact = 1e-4 * 0.05L * trillion + (0.05 - 0.05L) * 1e-4 * trillion;
  EXPECT_NEAR(clock.strain(trillion) / static_cast<double>(exact), 1.0, 3e-16);
  EXPECT_NEAR(clock.time(trillion), 5e10, 1e-5);
  for (std::int64_t const step : {trillion - 1, trillion, trillion + 17})
    EXPECT_NEAR(clock.strain(step + 1) - clock.strain(step), 5e-6, 1e-9);  // an ulp of 5e6
}

TEST(Clock, OffsetAtABuildIsInTheBox) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 100000; ++k) {
    double const length = 4 + 100 * unit(random);
    double const offsets[] = {0.0,
                              length * unit(random),
                              std::nextafter(length, 0.0),
                              length,
                              -1e-20,
                              -length * unit(random),
                              1e-320,
                              17.3 * length};
    Clock const clock{1e-4 * unit(random), 0.05, length, offsets[random() % 8], 0.0};
    std::int64_t const build = static_cast<std::int64_t>(random() % trillion) * (random() % 2);
    double const offset = clock.offset(build, build);
    ASSERT_GE(offset, 0.0) << length << " " << clock.initial_offset << " " << build;
    ASSERT_LT(offset, length) << length << " " << clock.initial_offset << " " << build;
  }
}

/// A build is made right before the offset would be L: a turn short by less than half a last place
/// of L counts as a whole one.
TEST(Clock, OffsetAtABuildNeverRoundsUpToTheLength) {
  for (double const length : {1.0, 3.3, 35.0, 38.6, 1e4})
    for (double const below : {0.0, 1e-20, 1e-18, 3e-17, 1e-16, 1e-15})
      for (std::int64_t const steps : {0, 1, 1000}) {
        // initial offset 3/4 L, then a quarter turn less `below`, in `steps` steps
        double const step_strain = steps == 0 ? 0.0 : (0.25 - below) / static_cast<double>(steps);
        Clock const clock{step_strain, 1.0, length, 0.75 * length, 0.0};
        double const offset = clock.offset(steps, steps);
        EXPECT_GE(offset, 0.0);
        EXPECT_LT(offset, length);
        EXPECT_NEAR(clock.offset(steps + 10, steps) - offset, 10 * step_strain * length,
                    1e-14 * length);
      }
}

TEST(Clock, BetweenBuildsTheOffsetGrowsOn) {
  Clock const clock{1e-3, 0.05, 20.0, 19.9999, 0.0};
  double before = clock.offset(0, 0);
  EXPECT_EQ(before, 19.9999);
  for (std::int64_t step = 1; step < 3000; ++step) {
    double const now = clock.offset(step, 0);
    ASSERT_NEAR(now - before, 1e-3, 1e-13);
    before = now;
  }
  EXPECT_GT(before, 20.0);
}

/// Whenever the list was built, images sit at the same places: offsets agree modulo L.
TEST(Clock, OffsetsOfAllBuildsAgreeModuloTheLength) {
  Clock const clock{1e-4, 0.05, 38.6, 12.3, 0.0};
  std::mt19937_64 random(6);
  for (int k = 0; k < 1000; ++k) {
    std::int64_t const step = static_cast<std::int64_t>(random() % trillion);
    double const at_step = clock.offset(step, step);
    for (std::int64_t const ago : {1, 100, 300000}) {
      if (ago > step) continue;
      double const turns = (clock.offset(step, step - ago) - at_step) / clock.box_length;
      ASSERT_NEAR(turns, std::round(turns), 1e-12) << step << " " << ago;
    }
  }
}

}  // namespace
}  // namespace bagnold
