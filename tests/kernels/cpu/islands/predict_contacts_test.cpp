// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/cpu/islands/predict_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernels/cpu/islands/islands.hpp"

namespace bagnold {
namespace {

/// Against the flight followed in many small steps.
TEST(MayMeet, IsTrueIfAndOnlyIfTheFlightComesNear) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int met = 0, missed = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    double const x = 1.5 * normal(random), y = 1.5 * normal(random);
    double const vx = normal(random), vy = normal(random), duration = 2, reach = 1;
    double nearest = 1e9;
    for (int k = 0; k <= 2000; ++k) {
      double const t = duration * k / 2000;
      nearest = std::min(nearest, std::hypot(x + vx * t, y + vy * t));
    }
    if (std::abs(nearest - reach) < 1e-3) continue;  // too close to call by steps
    bool const meets = may_meet({x, y, vx, vy}, reach, duration).any();
    EXPECT_EQ(meets, nearest < reach) << x << " " << y << " " << vx << " " << vy;
    ++(meets ? met : missed);
  }
  EXPECT_GT(met, 3000);
  EXPECT_GT(missed, 3000);
}

TEST(Islands, AreWhatMeetsUnfolded) {
  auto const pair = [](std::uint32_t a, std::uint32_t b, Image image) {
    return SlotPair{a, Neighbor::make(b, image)};
  };
  IslandFinder finder;
  finder.resize(100);
  Islands islands;
  finder.find({pair(3, 7, {0, 0}), pair(50, 60, {1, 0}), pair(7, 9, {0, 1}), pair(60, 70, {0, -1})},
              islands);
  ASSERT_EQ(islands.count(), 2u);
  EXPECT_TRUE(islands.unfolds);
  EXPECT_EQ(islands.first_disk, (std::vector<std::uint32_t>{0, 3, 6}));
  EXPECT_EQ(islands.first_pair, (std::vector<std::uint32_t>{0, 2, 4}));
  auto const image_of = [&](std::uint32_t slot) {
    for (auto const& disk : islands.disks)
      if (disk.slot == slot) return std::pair{disk.image.m, disk.image.n};
    return std::pair{-99, -99};
  };
  EXPECT_EQ(image_of(3), (std::pair{0, 0}));
  EXPECT_EQ(image_of(9), (std::pair{0, 1}));
  EXPECT_EQ(image_of(60), (std::pair{1, 0}));
  EXPECT_EQ(image_of(70), (std::pair{1, -1}));
  // A ring that closes on itself is one island; one that closes round the box cannot be unfolded.
  finder.find({pair(1, 2, {0, 0}), pair(2, 3, {1, 0}), pair(3, 1, {-1, 0})}, islands);
  EXPECT_EQ(islands.count(), 1u);
  EXPECT_EQ(islands.pairs.size(), 3u);
  EXPECT_TRUE(islands.unfolds);
  finder.find({pair(1, 2, {0, 0}), pair(2, 3, {1, 0}), pair(3, 1, {0, 0})}, islands);
  EXPECT_FALSE(islands.unfolds);
}

}  // namespace
}  // namespace bagnold
