// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/copies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/start/start_from_state.hpp"
#include "tests/support/equal.hpp"

namespace bagnold {
namespace {

double const rate = scene_from_state("CD_rot").shear.strain_rate;

Scene scene_of(std::int64_t count, double aspect) {
  Scene scene = scene_from_state("CD_rot");
  scene.disks.count = count;
  scene.disks.box_aspect = aspect;
  scene.start.copies = true;
  return scene;
}

/// 20 disks anywhere in a box twice as high as wide.
State some_state() {
  State state;
  state.box_aspect = 2;
  state.box_length = scene_of(20, 2).box_length();
  state.offset = 0.3 * state.box_length;
  state.time = 77;
  state.strain_rate = rate;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> of_one(0, 1);
  for (int i = 0; i < 20; ++i) {
    state.position.push_back(
        {of_one(random) * state.box_length, of_one(random) * state.box_height()});
    state.velocity.push_back(
        {rate * state.position.back()[1] + 1e-3 * of_one(random), 1e-3 * of_one(random)});
    state.spin.push_back(1e-3 * of_one(random));
    state.diameter.push_back(i % 2 == 0 ? 1.4 : 1.0);
  }
  return state;
}

using Neighbour = std::array<double, 6>;  ///< r_ij, v_ij, spin and diameter of j

/// All disks and images within a distance, Lees-Edwards: all pairs, all images.
std::vector<Neighbour> neighbours(State const& state, std::size_t i, double within) {
  std::vector<Neighbour> found;
  int const reach_x = 3 + static_cast<int>(within / state.box_length);
  int const reach_y = 1 + static_cast<int>(within / state.box_height());
  for (std::size_t j = 0; j < state.count(); ++j)
    for (int b = -reach_y; b <= reach_y; ++b)
      for (int a = -reach_x - reach_y; a <= reach_x + reach_y; ++a) {
        double const x =
            state.position[j][0] - state.position[i][0] + a * state.box_length + b * state.offset;
        double const y = state.position[j][1] - state.position[i][1] + b * state.box_height();
        if (std::hypot(x, y) < within)
          found.push_back({x, y,
                           state.velocity[j][0] - state.velocity[i][0] +
                               b * *state.strain_rate * state.box_height(),
                           state.velocity[j][1] - state.velocity[i][1], state.spin[j],
                           state.diameter[j]});
      }
  std::ranges::sort(found, [](Neighbour const& p, Neighbour const& q) {
    return std::hypot(p[0], p[1]) < std::hypot(q[0], q[1]);
  });
  return found;
}

/// Every disk of every copy sees what the disk it is a copy of sees.
TEST(Copies, EveryDiskHasTheNeighboursOfItsOriginal) {
  struct Case {
    std::int64_t count;
    double aspect;
  };
  State const one = some_state();
  for (auto const& [count, aspect] : {Case{20, 2}, Case{40, 4}, Case{40, 1}, Case{80, 2},
                                      Case{120, 3}, Case{120, 2. / 6}, Case{160, 1}, Case{60, 6}}) {
    SCOPED_TRACE(std::to_string(count) + " disks, L_y/L_x " + std::to_string(aspect));
    Scene const scene = scene_of(count, aspect);
    auto const started = fit_to_scene({one}, scene).front();  // the box is the scene's
    State const& many = started.state;
    EXPECT_EQ(started.record.at("start_copies"), static_cast<double>(count) / 20);
    ASSERT_EQ(many.count(), static_cast<std::size_t>(count));
    EXPECT_EQ(many.time, 77);
    EXPECT_GE(many.offset, 0);
    EXPECT_LT(many.offset, many.box_length);
    for (std::size_t i = 0; i < many.count(); ++i) {
      EXPECT_GE(many.position[i][0], 0);
      EXPECT_LT(many.position[i][0], many.box_length);
      EXPECT_GE(many.position[i][1], 0);
      EXPECT_LT(many.position[i][1], many.box_height());
      EXPECT_EQ(many.spin[i], one.spin[i % 20]);
      auto const expected = neighbours(one, i % 20, 4.0);
      auto const found = neighbours(many, i, 4.0);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t k = 0; k < found.size(); ++k)
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(found[k][c], expected[k][c], 1e-12);
    }
  }
}

TEST(Copies, OneCopyIsTheState) {
  State const one = some_state();
  State const same = copies(one, scene_of(20, 2));
  test::expect_equal(same, one);
}

/// At another rate the whole flow of the copies is scaled, that between them too (P2 Eqs. 40-41).
TEST(Copies, AreScaledToTheRateTogether) {
  Scene scene = scene_of(80, 2);
  scene.shear.strain_rate = rate / 2;
  State const many = fit_to_scene({some_state()}, scene).front().state;
  State const at_its_own = fit_to_scene({some_state()}, scene_of(80, 2)).front().state;
  for (std::size_t i = 0; i < 80; ++i)
    EXPECT_DOUBLE_EQ(many.velocity[i][0], at_its_own.velocity[i][0] / 2);
}

/// Across the boundaries of the box images move at the scene's rate; so must copies.
TEST(Copies, MoveAtTheRateThatTheyWillHave) {
  State one = some_state();
  Scene scene = scene_of(40, 4);
  scene.start.rescale = false;
  scene.shear.strain_rate = rate / 2;
  double const height = one.box_height();
  auto const jump = [&](State const& state) {
    State const many = fit_to_scene({state}, scene).front().state;
    return many.velocity[20][0] - many.velocity[0][0];
  };
  EXPECT_NEAR(jump(one), rate / 2 * height, 1e-15);
  one.strain_rate.reset();
  EXPECT_NEAR(jump(one), rate / 2 * height, 1e-15);
  scene.start.rescale = true;
  EXPECT_NEAR(jump(one), rate / 2 * height, 1e-15);
}

TEST(Copies, OfEachReplica) {
  Scene scene = scene_of(40, 1);
  scene.disks.replicas = 2;
  State other = some_state();
  other.position[3][0] += 0.01;
  auto const started = fit_to_scene({some_state(), other}, scene);
  ASSERT_EQ(started.size(), 2u);
  EXPECT_EQ(started[1].state.position[3], other.position[3]);
  EXPECT_EQ(started[1].state.count(), 40u);
}

std::string refusal(std::int64_t count, double aspect, bool wanted = true, double phi = 0.7) {
  Scene scene = scene_of(count, aspect);
  scene.disks.packing_fraction = phi;
  scene.start.copies = wanted;
  return refusal({some_state()}, scene);
}

TEST(Copies, ThatCannotFillTheBoxAreRefused) {
  EXPECT_EQ(refusal(80, 2), "accepted");
  EXPECT_TRUE(names(refusal(50, 2),
                    {"/folder/state.h5", "20 disks", "disks.count = 50", "set disks.count = 40"}));
  EXPECT_TRUE(names(refusal(10, 2), {"20 disks", "disks.count = 10", "set disks.count = 20"}));
  EXPECT_TRUE(names(refusal(80, 1), {"box_aspect = 2", "disks.box_aspect = 1 ", "k_x k_y = 4"}));
  EXPECT_TRUE(names(refusal(80, 1.5), {"set disks.box_aspect = 2, k_x = 2 and k_y = 2"}));
  EXPECT_TRUE(names(refusal(120, 0.3), {"set disks.box_aspect = 0.3333"}));
  EXPECT_TRUE(names(refusal(80, 2 + 1e-8), {"disks.box_aspect"}));
  EXPECT_TRUE(names(refusal(80, 2, false), {"disks.count = 80", "or start.copies = true"}));
  EXPECT_FALSE(names(refusal(50, 2, false), {"start.copies"}));
  EXPECT_TRUE(names(refusal(80, 2, true, 0.6), {"box_length", "disks.count = 20", "0.6"}));
}

}  // namespace
}  // namespace bagnold
