// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/deep_overlaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bagnold {
namespace {

State some_state(std::size_t count, double length, unsigned seed, double aspect = 1.0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> boxes(-3, 3);
  State state;
  state.box_length = length;
  state.box_aspect = aspect;
  state.offset = 0.3 * length;
  for (std::size_t disk = 0; disk < count; ++disk) {
    state.position.push_back({boxes(random) * length, boxes(random) * state.box_height()});
    state.diameter.push_back(disk % 2 == 0 ? 1.0 : 1.4);
  }
  return state;
}

/// All pairs, all images.
DeepOverlaps by_all_pairs(State const& s, double limit) {
  DeepOverlaps found;
  for (std::size_t i = 0; i < s.count(); ++i)
    for (std::size_t j = i + 1; j < s.count(); ++j)
      for (int row = -8; row <= 8; ++row)
        for (int column = -12; column <= 12; ++column) {
          double const x =
              s.position[i][0] - s.position[j][0] + row * s.offset + column * s.box_length;
          double const y = s.position[i][1] - s.position[j][1] + row * s.box_height();
          double const overlap = 1 - 2 * std::hypot(x, y) / (s.diameter[i] + s.diameter[j]);
          if (!(overlap > limit)) continue;
          ++found.pairs;
          if (overlap > found.deepest) found.deepest = overlap, found.disk = i, found.neighbour = j;
        }
  return found;
}

TEST(DeepOverlaps, AreThoseOfAllPairs) {
  std::int64_t pairs = 0;
  constexpr std::pair<double, double> boxes[] = {{3.0, 1.0},  {5.7, 1.0},  {12.0, 1.0},
                                                 {40.0, 1.0}, {3.0, 16.0}, {48.0, 1.0 / 16}};
  for (auto const& [length, aspect] : boxes)
    for (unsigned seed = 1; seed <= 5; ++seed) {
      State const state = some_state(60, length, seed, aspect);
      auto const expected = by_all_pairs(state, 0.2), found = deep_overlaps(state, 0.2);
      EXPECT_EQ(found.pairs, expected.pairs) << length << " " << aspect;
      EXPECT_NEAR(found.deepest, expected.deepest, 1e-12) << length << " " << aspect;
      EXPECT_EQ(found.disk, expected.disk) << length << " " << aspect;
      EXPECT_EQ(found.neighbour, expected.neighbour) << length << " " << aspect;
      pairs += found.pairs;
    }
  EXPECT_GT(pairs, 1000);
}

/// Also where more pairs overlap than deep_overlaps counts.
TEST(LargestOverlap, IsThatOfAllPairs) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    State const state = some_state(60, 12.0, seed);
    EXPECT_NEAR(largest_overlap(state), by_all_pairs(state, 0).deepest, 1e-12);
  }
  State apart;
  apart.box_length = 10;
  apart.position = {{1, 1}, {5, 5}};
  apart.diameter = {1, 1.4};
  EXPECT_EQ(largest_overlap(apart), 0);
  State row;
  row.box_length = 6000;
  row.box_aspect = 1e-3;
  for (int i = 0; i < 2000; ++i) row.position.push_back({10 + 1e-7 * i, 3.0});
  row.position.insert(row.position.end(), 2, {5000.0, 3.0});
  row.diameter.assign(row.count(), 1.0);
  ASSERT_EQ(deep_overlaps(row, 0).pairs, DeepOverlaps::most_pairs);
  EXPECT_EQ(largest_overlap(row), 1);
}

TEST(DeepOverlaps, NeitherHeapsNorWildNumbersHoldItUp) {
  State state = some_state(200'000, 700.0, 1);
  for (auto& position : state.position) position = {1.0, 2.0};
  EXPECT_EQ(deep_overlaps(state, 0.2).pairs, DeepOverlaps::most_pairs);
  for (auto& position : state.position) position = {1.7e308, -1.7e308};
  state.offset = 1e308;
  EXPECT_GT(deep_overlaps(state, 0.2).pairs, 0);
}

}  // namespace
}  // namespace bagnold
