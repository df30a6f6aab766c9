// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/course.hpp"

#include <gtest/gtest.h>

namespace bagnold::bias {
namespace {

Scene scene_of(double rate, std::string const& scheme, double time_step) {
  Scene scene;
  scene.disks = {
      .model = "CD", .count = 256, .packing_fraction = 0.82, .elasticity = 1, .mass = "equal"};
  scene.shear.strain_rate = rate;
  scene.integration.scheme = scheme;
  scene.integration.time_step = time_step;
  scene.integration.skin = 0.5;
  scene.measure.contacts = true;
  return scene;
}

/// A pair of a bias that scatters.
Pair pair_of(int k, double bias, double scatter) {
  double const s = scatter * (k % 3 - 1);
  return {k, {1 + bias + s, 1 + bias, 1 + s, 1, 1e-4, 1}, {1, 1, 1, 1, 1e-4, 1}};
}

TEST(BiasMethods, FinerOnes) {
  auto const implicit = methods_of(scene_of(1e-4, "implicit-damping", 1.5));
  EXPECT_EQ(implicit.fine.integration.scheme, "two-stage-leapfrog");
  EXPECT_EQ(implicit.ratio, 8);  // 1.5/8 is the first below 0.2
  EXPECT_EQ(implicit.fine.integration.time_step.number, 1.5 / 8);
  EXPECT_EQ(implicit.fine.integration.skin.word, "auto");
  EXPECT_EQ(implicit.third, 67);  // 0.01/1.5e-4
  EXPECT_EQ(implicit.grid, 2000);
  auto const two = methods_of(scene_of(0.1, "two-stage-leapfrog", 0.2));
  EXPECT_EQ(two.ratio, 4);
  EXPECT_EQ(two.fine.integration.time_step.number, 0.05);
  EXPECT_EQ(two.length(), 12);  // ten at least
  EXPECT_EQ(two.grid, 15);
  EXPECT_EQ(two.coarse.integration.engine, "steps");
  EXPECT_FALSE(two.coarse.measure.contacts);
}

/// Places of a right method: 1, 2, 3, 4, then each at twice the one before.
TEST(BiasCourse, LooksLessOftenOnceItKnows) {
  Course course(scene_of(1e-4, "implicit-damping", 1.6), 1);
  auto const grid = course.methods().grid;
  std::vector<std::int64_t> places;
  for (int k = 0; k < 9; ++k) {
    ASSERT_TRUE(course.takes(0));
    places.push_back(course.next(0) / grid);
    course.add(0, pair_of(k, 0, 0));
    EXPECT_EQ(course.findings().judgement.verdict, k < 3 ? Verdict::none : Verdict::accepted);
  }
  EXPECT_EQ(places, (std::vector<std::int64_t>{1, 2, 3, 4, 8, 16, 32, 64, 128}));
  ASSERT_EQ(course.findings().looks.size(), 1U);
  EXPECT_EQ(course.findings().looks[0].pairs, 4U);
}

/// A method on the edge gets twenty pairs one after the other and is then open.
TEST(BiasCourse, EndsOpen) {
  Course course(scene_of(1e-4, "implicit-damping", 1.6), 1);
  for (int k = 0; k < 20; ++k) {
    EXPECT_EQ(course.next(0) / course.methods().grid, k + 1);
    course.add(0, pair_of(k, 0.009, 1e-3));
    EXPECT_EQ(course.findings().judgement.verdict, k < 19 ? Verdict::none : Verdict::open);
  }
  EXPECT_EQ(course.next(0) / course.methods().grid, 40);
}

/// Replicas wait for each other at the place that depends on others, and their order is of no
/// account.
TEST(BiasCourse, ReplicasShareOneSum) {
  auto const scene = scene_of(1e-4, "implicit-damping", 1.6);
  Course one(scene, 3), other(scene, 3);
  auto const pair = [](std::size_t r, int round) {
    return pair_of(7 * static_cast<int>(r) + round, 0.002, 2e-3);
  };
  one.add(0, pair(0, 0));
  EXPECT_FALSE(one.takes(0));
  EXPECT_EQ(one.next(0), 2 * one.methods().grid);
  EXPECT_EQ(one.next(1), one.methods().grid);
  EXPECT_EQ(one.findings().pairs, 0U);
  for (std::size_t r : {1, 2}) one.add(r, pair(r, 0));
  EXPECT_TRUE(one.takes(0));
  EXPECT_EQ(one.findings().pairs, 3U);
  for (std::size_t r : {2, 1, 0}) other.add(r, pair(r, 0));
  for (std::size_t r : {0, 1, 2}) one.add(r, pair(r, 1));
  for (std::size_t r : {1, 0, 2}) other.add(r, pair(r, 1));
  EXPECT_EQ(one.findings().pairs, 6U);
  for (std::size_t q = 0; q < quantities; ++q) {
    EXPECT_EQ(one.findings().judgement.stated[q].value, other.findings().judgement.stated[q].value);
    EXPECT_EQ(one.findings().judgement.stated[q].error, other.findings().judgement.stated[q].error);
  }
  EXPECT_EQ(one.findings().judgement.verdict, other.findings().judgement.verdict);
}

TEST(BiasCourse, GoesOnFromItsNumbers) {
  auto const scene = scene_of(1e-4, "implicit-damping", 1.6);
  Course whole(scene, 1), first(scene, 1), second(scene, 1);
  for (int k = 0; k < 11; ++k) whole.add(0, pair_of(k, 0.009, 1e-3));
  for (int k = 0; k < 7; ++k) first.add(0, pair_of(k, 0.009, 1e-3));
  second.load(0, first.save(0));
  for (int k = 7; k < 11; ++k) second.add(0, pair_of(k, 0.009, 1e-3));
  EXPECT_EQ(second.save(0), whole.save(0));
  EXPECT_EQ(second.next(0), whole.next(0));
}

}  // namespace
}  // namespace bagnold::bias
