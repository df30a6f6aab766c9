// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/course.hpp"

#include <gtest/gtest.h>

#include <limits>

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

/// Implicit damping, whose steps are 8 of the run's.
TEST(BiasMethods, BesideQuasiStaticSteps) {
  auto scene = scene_of(1e-7, "auto", 0.2);
  auto const pair = methods_of(scene, {}, {"backward-euler", 1496});
  EXPECT_EQ(pair.coarse.integration.engine, "quasi-static");
  EXPECT_EQ(pair.fine.integration.scheme, "implicit-damping");
  EXPECT_EQ(pair.fine.integration.engine, "steps");
  EXPECT_EQ(pair.ratio, 187);
  EXPECT_DOUBLE_EQ(*pair.fine.integration.time_step.number, 1.6);
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

/// More pairs tell a smaller bias: where one is asked for, a method is open after 510 of them.
TEST(BiasCourse, AsksLongerForASmallerBias) {
  auto scene = scene_of(1e-4, "implicit-damping", 1.6);
  scene.integration.accuracy = 1e-3;
  Course edge(scene, 1), right(scene, 1);
  for (int k = 0; k < 510; ++k) {
    EXPECT_EQ(edge.findings().judgement.verdict, Verdict::none) << k;
    edge.add(0, pair_of(k, 9e-4, 1e-3));
  }
  EXPECT_EQ(edge.findings().judgement.verdict, Verdict::open);
  int pairs = 0;
  for (; right.findings().judgement.verdict == Verdict::none && pairs < 510; ++pairs)
    right.add(0, pair_of(pairs, 0, 3e-3));
  EXPECT_EQ(right.findings().judgement.verdict, Verdict::accepted);
  EXPECT_GT(pairs, 20);
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

/// A dense flow whose method is chosen: implicit damping at 1.6, two stages at 0.4, implicit
/// damping at 0.8, two stages at 0.2.
Scene to_be_chosen(double accuracy = 0.01) {
  Scene scene = scene_of(1e-4, "auto", 0.2);
  scene.integration.accuracy = accuracy;
  scene.measure.contacts = false;
  return scene;
}

std::int64_t place_of(Course const& course) {
  return course.next(0) / ladder_of(to_be_chosen()).grid;
}

TEST(BiasCourse, PlacesAreAStretchApart) {
  auto const ladder = ladder_of(to_be_chosen());
  EXPECT_NEAR(static_cast<double>(ladder.grid) * 0.2 * 1e-4, stretch_strain, 0.1 * stretch_strain);
}

/// Goes on to the next place with a pair, past those where a method of the run is watched.
void go_to_pair(Course& course) {
  while (auto const none = course.without_pair(course.next(0), 5e-5, true)) course.add(0, *none);
}

double step_of(Methods const& methods) { return *methods.coarse.integration.time_step.number; }

TEST(BiasCourse, TakesTheCheapestThatIsRight) {
  Course course(to_be_chosen(), 1);
  EXPECT_TRUE(course.chooses());
  EXPECT_EQ(course.method(), 3U);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(course.method(), 3U);
    EXPECT_EQ(place_of(course), k + 1);
    EXPECT_EQ(step_of(course.methods()), 1.6);
    course.add(0, pair_of(k, 0.001, 1e-3));
  }
  EXPECT_EQ(course.method(), 0U);
  EXPECT_EQ(course.dropped(), 0);
  EXPECT_NE(course.changes()[0].find("strain 0.15"), std::string::npos) << "the end of the fourth";
  EXPECT_EQ(place_of(course), 8) << "inertia is looked for at each strain of 0.1, three places";
  go_to_pair(course);
  EXPECT_EQ(place_of(course), 12);
  course.add(0, pair_of(4, 0.001, 1e-3));
  EXPECT_EQ(place_of(course), 16);
  go_to_pair(course);
  EXPECT_EQ(place_of(course), 36);
  auto const found = course.findings();
  EXPECT_EQ(found.pairs, 5U);
  EXPECT_EQ(found.judgement.verdict, Verdict::accepted);
  EXPECT_TRUE(found.taken);
  EXPECT_EQ(step_of(found.methods), 1.6);
  EXPECT_TRUE(found.tried.empty());
  ASSERT_EQ(course.changes().size(), 1U);
  EXPECT_NE(course.changes()[0].find("accepted after 4 pairs"), std::string::npos);
}

/// Refused ones cost no windows, and places are farther apart from one to the next.
TEST(BiasCourse, GoesUpTheLadder) {
  Course course(to_be_chosen(), 1);
  std::vector<std::int64_t> places;
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0.1, 1e-3));
  for (int k = 0; k < 9; ++k) {  // on the edge, beside steps of 0.1 apart from the run
    EXPECT_EQ(step_of(course.methods()), 0.4);
    places.push_back(place_of(course));
    course.add(0, pair_of(k, 0.009, 1e-3));
  }
  EXPECT_EQ(places, (std::vector<std::int64_t>{7, 9, 11, 13, 15, 17, 19, 21, 23}));
  EXPECT_EQ(step_of(course.methods()), 0.8);
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0.1, 1e-3));
  EXPECT_EQ(course.method(), 3U);
  EXPECT_EQ(course.dropped(), 0);
  EXPECT_EQ(course.next(0), std::numeric_limits<std::int64_t>::max());
  auto const found = course.findings();
  EXPECT_EQ(found.judgement.verdict, Verdict::usual);
  EXPECT_EQ(step_of(found.methods), 0.2);
  ASSERT_EQ(found.tried.size(), 3U);
  EXPECT_EQ(found.tried[0].judgement.verdict, Verdict::refused);
  EXPECT_EQ(found.tried[1].judgement.verdict, Verdict::open);
  EXPECT_EQ(found.tried[1].pairs, 9U);
}

/// A method that the run stepped by and that is refused later takes its windows with it.
TEST(BiasCourse, LeavesWhatItTook) {
  Course course(to_be_chosen(), 1);
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0, 1e-3));
  EXPECT_EQ(course.method(), 0U);
  Course failed = course, refused = course;
  auto const here = course.next(0);
  course.add(0, course.without_pair(here, 4e-4, true).value());
  EXPECT_EQ(course.dropped(), here);
  for (auto* one : {&failed, &refused}) go_to_pair(*one);
  auto const pair_here = failed.next(0);
  EXPECT_FALSE(failed.without_pair(pair_here, 2.9e-4, true));
  failed.add(0, Pair::failed(pair_here));
  EXPECT_EQ(failed.dropped(), pair_here + failed.grid()) << "at the end of the round";
  for (int k = 4; refused.method() == 0 && k < 12; ++k) {
    refused.add(0, pair_of(k, 0.5, 0));
    if (refused.method() == 0) go_to_pair(refused);
  }
  EXPECT_GE(refused.dropped(), pair_here);
  for (auto const* one : {&course, &failed, &refused}) {
    EXPECT_EQ(one->method(), 3U);
    EXPECT_EQ(step_of(one->methods()), 0.4) << "the next one is tried";
    auto const& left = one->findings().tried.front();
    EXPECT_TRUE(left.taken);
    EXPECT_EQ(left.reason, one == &course ? "inertia" : one == &failed ? "a step failed" : "");
    double const strain = static_cast<double>(one->dropped()) * 0.2 * 1e-4;
    EXPECT_NEAR(one->findings().dropped_strain, strain, 1e-12);
  }
}

/// Creep, in which quasi-static steps are tried before implicit damping.
Scene creeping() {
  auto scene = to_be_chosen();
  scene.shear.strain_rate = 1e-7;
  return scene;
}

/// While quasi-static steps are on trial the run is the finer side of their pairs. Stretches are
/// short, and judged from the ninth on.
TEST(BiasCourse, StepsBesideQuasiStaticSteps) {
  auto const ladder = ladder_of(creeping());
  ASSERT_EQ(ladder.methods[0].scheme, "backward-euler");
  ASSERT_EQ(ladder.methods[1], (Method{"implicit-damping", 8}));
  ASSERT_TRUE(ladder.shares);
  Course course(creeping(), 1);
  EXPECT_EQ(course.method(), ladder.usual);
  EXPECT_EQ(course.own(), Own::neither);
  course.add(0, pair_of(0, 0.001, 1e-3));
  EXPECT_EQ(course.method(), 1U);
  EXPECT_EQ(course.own(), Own::fine);
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::none) << "nothing is known of it";
  Course refused(creeping(), 1), inertial = course;
  for (int k = 1; k < 9; ++k) course.add(0, pair_of(k, 0.001, 1e-3));
  EXPECT_EQ(course.method(), 0U);
  EXPECT_EQ(course.own(), Own::neither) << "with a verdict pairs lie farther apart";
  EXPECT_EQ(course.dropped(), 0);

  for (int k = 0; k < 9; ++k) refused.add(0, pair_of(k, 0.1, 1e-3));
  EXPECT_EQ(step_of(refused.methods()), 1.6) << "implicit damping is next on trial";
  EXPECT_EQ(refused.method(), ladder.usual);
  EXPECT_GT(refused.dropped(), 0);
  for (int k = 0; k < 9; ++k) refused.add(0, pair_of(k, 0.001, 1e-3));
  EXPECT_EQ(refused.method(), 1U);

  auto const here = inertial.next(0);
  EXPECT_FALSE(inertial.without_pair(here, 2e-4, true)) << "beside the trial a run bears more";
  inertial.add(0, inertial.without_pair(here, 4e-4, true).value());
  EXPECT_EQ(inertial.method(), ladder.usual);
  EXPECT_GE(inertial.dropped(), here);
  EXPECT_NE(inertial.changes().back().find("no longer on trial (inertia)"), std::string::npos);
  EXPECT_EQ(inertial.methods().coarse.integration.scheme, "backward-euler") << "it is tried again";
  inertial.add(0, Pair::failed(inertial.next(0)));
  EXPECT_EQ(inertial.method(), ladder.usual);
  EXPECT_EQ(step_of(inertial.methods()), 1.6);
}

/// Many replicas decide in one round: no method is taken beside a trial that is over.
TEST(BiasCourse, ReplicasNeedNothingBesideATrialOfOneRound) {
  Course course(creeping(), 9);
  for (std::size_t r = 0; r < 9; ++r) course.add(r, pair_of(static_cast<int>(r), 0.001, 1e-3));
  EXPECT_EQ(course.method(), 0U);
  EXPECT_EQ(course.changes().size(), 1U);
}

/// Inertia in a few replicas of many delays a trial, and does not end it.
TEST(BiasCourse, FewReplicasWithInertiaEndNoTrial) {
  Course course(to_be_chosen(), 5);
  for (int k = 0; k < 8; ++k) {
    auto const here = course.next(0);
    for (std::size_t r = 0; r < 5; ++r)
      course.add(r, r < 2 ? Pair::skipped(here) : pair_of(k, 0.02, 0.03));
  }
  EXPECT_EQ(step_of(course.methods()), 1.6);
}

/// A method that was accepted and of which pairs tell less later is kept, with pairs at 1.5 times
/// the strain each time.
TEST(BiasCourse, KeepsWhatLaterPairsLeaveOpen) {
  Course course(to_be_chosen(), 1);
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0.001, 1e-3));
  ASSERT_EQ(course.method(), 0U);
  std::vector<std::int64_t> places;
  for (int k = 0; k < 24; ++k) {
    go_to_pair(course);
    places.push_back(place_of(course));
    course.add(0, pair_of(k, 0.001, 0.2));
  }
  EXPECT_EQ(course.method(), 0U);
  EXPECT_EQ(course.dropped(), 0);
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::none);
  EXPECT_EQ(places[0], 12);
  for (std::size_t k = 1; k < 12; ++k) EXPECT_EQ(places[k], places[k - 1] + places[k - 1] / 2) << k;
}

/// What is not Newtonian yet is looked at again, more and more seldom, without pairs.
TEST(BiasCourse, WaitsWhileInertiaHasAPart) {
  Course course(to_be_chosen(), 1);
  std::vector<std::int64_t> places;
  for (int k = 0; k < 4; ++k) {
    places.push_back(place_of(course));
    course.add(0, Pair::skipped(course.next(0)));
  }
  EXPECT_EQ(places, (std::vector<std::int64_t>{1, 2, 4, 8}));
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::usual);
  ASSERT_EQ(course.findings().tried.size(), 1U);
  EXPECT_EQ(course.findings().tried[0].reason, "inertia");
  EXPECT_EQ(course.findings().coarse_steps, 0);
  Course warm = course;
  for (int k = 0; k < 2; ++k) warm.add(0, Pair::skipped(warm.next(0)));
  EXPECT_EQ(step_of(warm.methods()), 0.4) << "no longer: the next one that does not damp all";
  EXPECT_TRUE(course.without_pair(course.next(0), 1.1e-4, true)->is_skipped());
  EXPECT_FALSE(course.without_pair(course.next(0), 0.9e-4, true));
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0, 1e-3));
  EXPECT_EQ(course.method(), 0U);
}

/// Where the usual method is to be judged, no cheaper one is waited for.
TEST(BiasCourse, WaitsNoLongerWhereFinerOnesAreAskedFor) {
  Course course(to_be_chosen(1e-3), 1);
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::none) << "the usual one is to be judged";
  std::int64_t last = 0;
  for (int k = 0; k < 5; ++k) course.add(0, Pair::skipped(last = course.next(0)));
  EXPECT_GT(static_cast<double>(last) * 0.2 * 1e-4, 0.4) << "not in the transient alone";
  EXPECT_EQ(step_of(course.methods()), 0.2);  // at 0.4 a collision is off by 0.16%
  ASSERT_EQ(course.findings().tried.size(), 1U);
  EXPECT_EQ(course.findings().tried[0].reason, "inertia");
}

/// Events take the place of steps: no pair, and it is said why.
TEST(BiasCourse, WaitsWhileEventsStep) {
  Course course(to_be_chosen(), 1);
  course.add(0, course.without_pair(course.next(0), 1e-5, false).value());
  ASSERT_EQ(course.findings().tried.size(), 1U);
  EXPECT_EQ(course.findings().tried[0].reason, "events");
}

/// One replica with inertia is enough to leave the method of all.
TEST(BiasCourse, ReplicasLeaveTogether) {
  Course course(to_be_chosen(), 2);
  for (int k = 0; k < 3; ++k)  // at places 1, 2, 4
    for (std::size_t r : {0, 1}) course.add(r, pair_of(k, 0.001, 1e-4));
  ASSERT_EQ(course.method(), 0U);
  auto const here = course.next(0);
  course.add(0, course.without_pair(here, 5e-5, true).value());
  EXPECT_FALSE(course.takes(0)) << "it waits";
  EXPECT_EQ(course.method(), 0U);
  course.add(1, course.without_pair(here, 1e-3, true).value());
  EXPECT_EQ(course.method(), 3U);
  EXPECT_EQ(course.dropped(), here);
}

/// The side of a pair that the run steps itself comes at the next place, and so does what follows.
TEST(BiasCourse, OneStretchIsTheRunsOwn) {
  Course course(to_be_chosen(), 2);
  auto const grid = course.grid();
  Averages const other{1, 1, 1, 1, 1e-4, 1};
  EXPECT_EQ(course.own(), Own::fine) << "of implicit damping beside two stages";
  EXPECT_EQ(course.methods().length() * 8, grid);
  auto const [first, last] = course.windows_from(grid);
  EXPECT_EQ(first, 3);
  EXPECT_EQ(last, 6);
  course.begin(0, grid, other);
  EXPECT_TRUE(course.takes(0)) << "it goes on";
  EXPECT_EQ(course.next(0), 2 * grid);
  EXPECT_EQ(course.next(1), grid);
  course.add(1, Pair::skipped(grid));
  EXPECT_FALSE(course.takes(1));
  EXPECT_EQ(course.next(1), 2 * grid) << "where the round ends, not where it skipped";
  Course other_run(to_be_chosen(), 2);
  for (std::size_t r : {1, 0}) other_run.load(r, course.save(r));
  ASSERT_TRUE(other_run.begun(0));
  EXPECT_EQ(other_run.begun(0)->step, grid);
  EXPECT_EQ(other_run.begun(0)->other, other);
  EXPECT_FALSE(other_run.begun(1));
  course.add(0, {grid, other, other});
  EXPECT_FALSE(course.begun(0));
  EXPECT_EQ(course.next(0), 2 * grid) << "at twice the strain, as one was skipped";
  EXPECT_EQ(course.findings().coarse_steps, course.methods().length());
  EXPECT_EQ(course.findings().fine_steps, 0) << "that of the run is no other one";
  for (int k = 0; k < 4; ++k)
    for (std::size_t r : {0, 1}) course.add(r, pair_of(k, 0, 1e-3));
  ASSERT_EQ(course.method(), 0U);
  EXPECT_EQ(course.own(), Own::neither) << "a look at inertia";
  while (auto const none = course.without_pair(course.next(0), 5e-5, true))
    for (std::size_t r : {0, 1}) course.add(r, *none);
  EXPECT_EQ(course.own(), Own::coarse);
}

/// A pair beside the run costs little, so 13 are taken before a method is open.
TEST(BiasCourse, TriesLongerBesideTheRun) {
  Course course(to_be_chosen(), 1);
  for (int k = 0; k < 13; ++k) {
    EXPECT_EQ(step_of(course.methods()), 1.6) << k;
    course.add(0, pair_of(k, 0.009, 1e-3));
  }
  EXPECT_EQ(step_of(course.methods()), 0.4);
  EXPECT_EQ(course.findings().tried[0].judgement.verdict, Verdict::open);
}

/// Stretches at small rates are short: four times as many are tried, over as much strain.
TEST(BiasCourse, TriesMorePairsOfShortStretches) {
  auto scene = to_be_chosen();
  scene.shear.strain_rate = 2.5e-6;
  scene.disks.count = 1024;  // too many for quasi-static steps
  Course course(scene, 1);
  EXPECT_NEAR(course.methods().strain(), 0.25 * stretch_strain, 0.02 * stretch_strain);
  for (int k = 0; k < 52; ++k) {
    EXPECT_EQ(step_of(course.methods()), 1.6) << k;
    course.add(0, pair_of(k, 0.009, 1e-3));
  }
  EXPECT_EQ(step_of(course.methods()), 0.4);
  EXPECT_EQ(course.findings().tried[0].judgement.verdict, Verdict::open);
}

/// Stretches are apart from the run where neither side is its own, or its windows are too long.
TEST(BiasCourse, StretchesApartFromTheRun) {
  Course sharp(to_be_chosen(1e-3), 1);
  EXPECT_EQ(sharp.own(), Own::neither) << "beside two stages at a quarter of their rule";
  auto scene = to_be_chosen();
  for (double const strain : {0.002, 0.01, 0.014}) {
    scene.output.sample_strain = strain;
    EXPECT_EQ(Course(scene, 1).own(), Own::fine) << strain;
  }
  for (double const strain : {0.016, 0.05}) {
    scene.output.sample_strain = strain;
    Course course(scene, 1);
    EXPECT_EQ(course.own(), Own::neither) << strain;
    EXPECT_NEAR(course.methods().strain(), stretch_strain, 0.1 * stretch_strain);
    course.add(0, pair_of(0, 0.001, 1e-3));
    EXPECT_EQ(course.next(0), 2 * course.grid());
  }
}

/// A small accuracy: the usual method is judged too, and finer ones follow it.
TEST(BiasCourse, GoesOnToFinerSteps) {
  Course course(to_be_chosen(1e-3), 1);
  EXPECT_EQ(course.methods().ratio, 32) << "beside two stages at a quarter of their rule";
  while (course.method() == 2U && step_of(course.methods()) != 0.2)
    course.add(0, pair_of(static_cast<int>(course.next(0)), 0.1, 1e-5));
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0.002, 1e-5));
  EXPECT_EQ(course.method(), 3U);
  EXPECT_GT(course.dropped(), 0);
  for (int k = 0; k < 4; ++k) course.add(0, pair_of(k, 0, 1e-5));
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::accepted);
  EXPECT_EQ(step_of(course.findings().methods), 0.1);
}

TEST(BiasCourse, ChoosesAgainFromItsNumbers) {
  Course whole(to_be_chosen(), 2), second(to_be_chosen(), 2);
  auto const grid = static_cast<int>(whole.grid());
  auto const pair = [&](int k) { return pair_of(k * grid, k < 3 ? 0.1 : 0.001, 1e-3); };
  for (int k = 0; k < 9; ++k)
    for (std::size_t r : {0, 1}) whole.add(r, k == 5 ? Pair::skipped(k * grid) : pair(k));
  for (std::size_t r : {0, 1}) second.load(r, whole.save(r));
  EXPECT_EQ(second.method(), whole.method());
  EXPECT_EQ(second.next(0), whole.next(0));
  EXPECT_EQ(second.save(1), whole.save(1));
  EXPECT_EQ(second.dropped(), whole.dropped());
  EXPECT_EQ(second.changes(), whole.changes());
  auto elsewhere = whole.save(0);
  elsewhere[0] += 1;
  EXPECT_THROW(Course(to_be_chosen(), 2).load(0, elsewhere), InputError);
}

/// A failed step refuses a method that is named, and the run goes on.
TEST(BiasCourse, AFailedStepRefuses) {
  Course course(scene_of(1e-4, "implicit-damping", 1.6), 1);
  course.add(0, Pair::failed(1));
  for (int k = 0; k < 6; ++k) course.add(0, pair_of(k, 0, 1e-3));
  EXPECT_EQ(course.findings().judgement.verdict, Verdict::refused);
  EXPECT_EQ(course.findings().reason, "a step failed");
  EXPECT_EQ(course.findings().pairs, 6U);
}

}  // namespace
}  // namespace bagnold::bias
