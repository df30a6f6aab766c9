// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/cpu/islands/flight_times.hpp"

#include <gtest/gtest.h>

namespace bagnold {
namespace {

TEST(FlightTimes, AtOneRateAreStepsTimesTheStep) {
  FlightTimes flights;
  flights.clear(0.05);
  EXPECT_TRUE(flights.at_one_rate());
  for (std::int64_t const step : {0, 1, 16384}) {
    EXPECT_EQ(flights.time(step), static_cast<double>(step) * 0.05);
    EXPECT_EQ(flights.scale(step), 1);
    EXPECT_EQ(flights.time(7, 7 + step), static_cast<double>(step) * 0.05);
    EXPECT_EQ(flights.scale(7, 7 + step), 1);
  }
  EXPECT_EQ(flights.steps_until(3, 0.12), 2);
  EXPECT_GT(flights.longer_than(5, 10), 10.99 * 0.05);
}

/// A disk stepped with velocities that scale where the rate does.
TEST(FlightTimes, AreThoseOfStepsWhereTheRateChanges) {
  constexpr double dt = 0.25, speed = 3;
  constexpr std::int64_t steps = 40;
  auto const scale = [](std::int64_t step) { return 1 + 0.5 * static_cast<double>(step / 5 % 4); };
  FlightTimes flights;
  flights.clear(dt);
  for (std::int64_t s = 0; s <= steps; ++s) flights.add(scale(s));
  EXPECT_FALSE(flights.at_one_rate());
  std::vector<double> place{0};
  for (std::int64_t s = 0; s < steps; ++s) place.push_back(place.back() + dt * speed * scale(s));
  for (std::int64_t from = 0; from <= steps; ++from) {
    double const speed_there = speed * scale(from);
    for (std::int64_t to = from; to <= steps; ++to) {
      auto const way = place[static_cast<std::size_t>(to)] - place[static_cast<std::size_t>(from)];
      EXPECT_NEAR(speed_there * flights.time(from, to), way, 1e-13);
      EXPECT_NEAR(speed_there * flights.scale(from, to), speed * scale(to), 1e-13);
      auto const time = flights.time(from, to);
      EXPECT_EQ(flights.steps_until(from, time + 1e-9), to - from + (to == steps)) << from;
      if (to > from) {
        EXPECT_EQ(flights.steps_until(from, time - 1e-9), to - from - 1) << from;
      }
    }
    EXPECT_GT(flights.steps_until(from, flights.longer_than(from, steps - from)), steps - from);
  }
  EXPECT_EQ(flights.time(steps) * speed, place.back());
}

}  // namespace
}  // namespace bagnold
