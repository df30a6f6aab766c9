// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/even_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "src/start/random_pair.hpp"

namespace bagnold {
namespace {

State drawn(std::size_t count, double aspect) {
  State state;
  state.box_aspect = aspect;
  state.box_length = std::sqrt(1.2 * static_cast<double>(count) / aspect);
  for (std::size_t i = 0; i < count; ++i) {
    auto const [x, y] = random_pair(1, i, Purpose::position);
    state.position.push_back({x * state.box_length, y * state.box_height()});
    state.diameter.push_back(i < count / 2 ? 1.0 : 1.4);
  }
  return state;
}

/// Of the area of disks in n x n equal parts of the box, over its mean squared.
double variance_of_density(State const& state, std::size_t n) {
  std::vector<double> area(n * n, 0.0);
  for (std::size_t i = 0; i < state.count(); ++i) {
    auto const& [x, y] = state.position[i];
    auto const column = static_cast<std::size_t>(static_cast<double>(n) * x / state.box_length);
    auto const row = static_cast<std::size_t>(static_cast<double>(n) * y / state.box_height());
    area.at(row * n + column) += state.diameter[i] * state.diameter[i];
  }
  double mean = 0, variance = 0;
  for (double const a : area) mean += a / static_cast<double>(n * n);
  for (double const a : area) variance += (a / mean - 1) * (a / mean - 1);
  return variance / static_cast<double>(n * n);
}

TEST(EvenOut, TakesLongWavesOutOfTheDensity) {
  for (double const aspect : {1.0, 4.0, 0.25}) {
    State state = drawn(20000, aspect);
    double const random = 16.0 / 20000;
    EXPECT_NEAR(variance_of_density(state, 4), random, random / 2) << aspect;
    even_out(state);
    EXPECT_LT(variance_of_density(state, 4), random / 3) << aspect;  // those at the edges stay
  }
}

TEST(EvenOut, MovesDisksByAboutADiameterInsideTheBox) {
  for (double const aspect : {1.0, 4.0, 0.25}) {
    State const before = drawn(20000, aspect);
    State state = before;
    even_out(state);
    double mean2 = 0;
    for (std::size_t i = 0; i < state.count(); ++i) {
      auto const& [x, y] = state.position[i];
      ASSERT_TRUE(0 <= x && x < state.box_length && 0 <= y && y < state.box_height());
      double dx = x - before.position[i][0], dy = y - before.position[i][1];
      dx -= state.box_length * std::round(dx / state.box_length);
      dy -= state.box_height() * std::round(dy / state.box_height());
      mean2 += (dx * dx + dy * dy) / 20000;
    }
    EXPECT_GT(mean2, 0.04) << aspect;
    EXPECT_LT(mean2, 4.0) << aspect;
  }
}

/// Disks of one size on a square lattice that the squares of the grid fit.
TEST(EvenOut, LeavesEvenDensitiesAlone) {
  State state;
  state.box_length = 64;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) {
      state.position.push_back({column + 0.5, row + 0.5});
      state.diameter.push_back(1.0);
    }
  State const before = state;
  even_out(state);
  for (std::size_t i = 0; i < state.count(); ++i)
    for (int a : {0, 1}) EXPECT_NEAR(state.position[i][a], before.position[i][a], 1e-9);
}

}  // namespace
}  // namespace bagnold
