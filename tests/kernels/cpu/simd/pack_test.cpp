// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "kernels/cpu/simd/records.hpp"

namespace bagnold::simd {
namespace {

TEST(Pack, InverseSquareRootIsGoodToTwoUlp) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-40, 40);
  double worst = 0;
  for (int k = 0; k < 100'000; ++k) {
    Pack x;
    for (int lane = 0; lane < width; ++lane) x.v[lane] = std::exp2(exponent(random));
    Pack const y = inverse_sqrt(x);
    for (int lane = 0; lane < width; ++lane)
      worst = std::max(worst, std::abs(y.v[lane] * std::sqrt(x.v[lane]) - 1));
  }
  EXPECT_LT(worst, 2 * std::numeric_limits<double>::epsilon());
}

TEST(Pack, SelectTakesNothingFromTheOtherSide) {
  Pack const nan = std::numeric_limits<double>::quiet_NaN();
  constexpr int small = width / 2;
  Pack x;
  for (int k = 0; k < width; ++k) x.v[k] = k;
  auto const few = x < Pack(small);
  EXPECT_EQ(few.lanes(), (1u << small) - 1);
  Pack const picked = select(few, x, nan), zeroed = zero_unless(few, select(few, x, nan));
  for (int k = 0; k < width; ++k) {
    EXPECT_EQ(std::isnan(picked.v[k]), k >= small);
    EXPECT_EQ(zeroed.v[k], k < small ? k : 0);
  }
  EXPECT_EQ(sum(x), width * (width - 1) / 2);
  EXPECT_EQ(largest(x), width - 1);
  for (unsigned lanes = 0; lanes < 1u << width; ++lanes) EXPECT_EQ(Mask::of(lanes).lanes(), lanes);
}

TEST(Pack, TheLargerOfTwoIsNotNaN) {
  Pack const nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(max(Pack(1.0), nan).v[0], 1);
  EXPECT_EQ(positive_part(nan).v[0], 0);
  EXPECT_EQ(positive_part(Pack(-1.0)).v[0], 0);
  EXPECT_EQ(max(Pack(1.0), Pack(2.0)).v[width - 1], 2);
}

/// Loads, sums and scatters against plain loops, with disks that occur twice in one pack.
TEST(Records, AreMovedAsByPlainLoops) {
  constexpr int disks = 40;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  std::uniform_int_distribution<std::uint32_t> disk(0, disks - 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Record> records(disks);
    std::vector<double> values(disks);
    std::vector<Force> force(disks), force_before;
    std::vector<TurningForce> turning(disks), turning_before;
    for (int i = 0; i < disks; ++i) {
      records[i] = {number(random), number(random), number(random), number(random)};
      values[i] = number(random);
      force[i] = {number(random), number(random)};
      turning[i] = {number(random), 0, number(random), number(random)};
    }
    LocalPair pairs[width];
    for (auto& pair : pairs) pair = LocalPair::make(disk(random), disk(random));
    auto const d = load_differences(records.data(), pairs);
    auto const s = load_sums(values.data(), pairs, 1.4);
    Pack x, y, torque_per_diameter;
    for (int k = 0; k < width; ++k) {
      Record const &a = records[pairs[k].a()], &b = records[pairs[k].b()];
      EXPECT_EQ(d.x.v[k], a.x - b.x);
      EXPECT_EQ(d.y.v[k], a.y - b.y);
      EXPECT_EQ(d.vx.v[k], a.vx - b.vx);
      EXPECT_EQ(d.vy.v[k], a.vy - b.vy);
      EXPECT_NEAR(s.v[k], values[pairs[k].a()] + 1.4 * values[pairs[k].b()], 1e-15);
      x.v[k] = number(random);
      y.v[k] = number(random);
      torque_per_diameter.v[k] = number(random);
    }
    force_before = force;
    turning_before = turning;
    scatter(force.data(), pairs, x, y);
    scatter(turning.data(), pairs, x, y, torque_per_diameter);
    for (int k = 0; k < width; ++k) {
      auto const a = pairs[k].a(), b = pairs[k].b();
      force_before[a] = {force_before[a].x + x.v[k], force_before[a].y + y.v[k]};
      force_before[b] = {force_before[b].x - x.v[k], force_before[b].y - y.v[k]};
      auto& p = turning_before[a];
      p = {p.x + x.v[k], 0, p.y + y.v[k], p.torque_per_diameter + torque_per_diameter.v[k]};
      auto& q = turning_before[b];
      q = {q.x - x.v[k], 0, q.y - y.v[k], q.torque_per_diameter + torque_per_diameter.v[k]};
    }
    for (int i = 0; i < disks; ++i) {
      EXPECT_EQ(force[i].x, force_before[i].x);
      EXPECT_EQ(force[i].y, force_before[i].y);
      EXPECT_EQ(turning[i].x, turning_before[i].x);
      EXPECT_EQ(turning[i].y, turning_before[i].y);
      EXPECT_EQ(turning[i].torque_per_diameter, turning_before[i].torque_per_diameter);
    }
    auto const in_a_row = load_records(records.data() + 16);
    std::vector<Record> back(width);
    store_records(back.data(), in_a_row);
    auto const forces = load_forces(force.data() + 8);
    auto const turnings = load_forces(turning.data() + 8);
    for (int k = 0; k < width; ++k) {
      EXPECT_EQ(back[k].x, records[16 + k].x);
      EXPECT_EQ(back[k].vy, records[16 + k].vy);
      EXPECT_EQ(in_a_row.y.v[k], records[16 + k].y);
      EXPECT_EQ(in_a_row.vx.v[k], records[16 + k].vx);
      EXPECT_EQ(forces.x.v[k], force[8 + k].x);
      EXPECT_EQ(forces.y.v[k], force[8 + k].y);
      EXPECT_EQ(turnings.y.v[k], turning[8 + k].y);
      EXPECT_EQ(turnings.torque_per_diameter.v[k], turning[8 + k].torque_per_diameter);
    }
  }
}

TEST(Pack, RowsBecomeColumns) {
  Pack matrix[width];
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < width; ++j) matrix[i].v[j] = 10 * i + j;
  transpose(matrix);
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < width; ++j) EXPECT_EQ(matrix[i].v[j], 10 * j + i);
}

TEST(Records, AppendKeepsTheOrder) {
  LocalPair pairs[width], kept[width];
  for (std::uint32_t k = 0; k < width; ++k) pairs[k] = LocalPair::make(k, 100 + k);
  for (unsigned lanes = 0; lanes < 1u << width; ++lanes) {
    int const count = append(kept, Mask::of(lanes), pairs);
    int expected = 0;
    for (std::uint32_t k = 0; k < width; ++k)
      if (lanes >> k & 1) {
        EXPECT_EQ(kept[expected].a(), k);
        EXPECT_EQ(kept[expected++].b(), 100 + k);
      }
    EXPECT_EQ(count, expected);
  }
}

}  // namespace
}  // namespace bagnold::simd
