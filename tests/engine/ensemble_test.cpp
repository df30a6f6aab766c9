// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/errors.hpp"
#include "src/config/skin.hpp"
#include "src/engine/ensemble/ensemble_engine.hpp"
#include "tests/support/equal.hpp"
#include "tests/support/simulations.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {

/// Many systems in one launch against ReferenceEngine, a system at a time: the same bits.
template <class On>
class EnsembleOf : public testing::Test {
 public:
  using Law = typename On::Law;
  using Space = typename On::Space;
  template <class Repulsion>
  using Together = EnsembleEngine<Law, Repulsion, Space, typename On::Scheme>;
  using Kernel = AdvanceSystems<Law, HarmonicRepulsion, Space, typename On::Scheme>;
  using Simulations = std::vector<std::unique_ptr<Simulation>>;

  static Scene scene(double packing_fraction = 0.82, std::int64_t count = 64) {
    Scene scene = small_scene(std::string(Law::name), packing_fraction, count);
    scene.integration.scheme = On::Scheme::name;
    if (TwoStageScheme<typename On::Scheme>) scene.integration.time_step = 0.2;
    return scene;
  }

  /// Starts of consecutive seeds.
  static std::vector<Snapshot> starts(Scene scene, int systems) {
    std::vector<Snapshot> all;
    for (int s = 0; s < systems; ++s, ++scene.disks.seed)
      all.push_back(first_snapshot(shaken_start(scene)));
    return all;
  }

  template <class Repulsion = HarmonicRepulsion>
  static Simulations together(Scene const& scene, std::vector<Snapshot> const& from,
                              int threads = 0) {
    return members_of(std::make_shared<Together<Repulsion>>(
        make_law<Law>(scene.disks), make_species_table(scene.mass_by_area()), strain_rates(scene),
        time_step(scene), skin(scene), from, threads));
  }

  /// On the program's reference engine.
  static std::unique_ptr<Simulation> alone(Scene scene, Snapshot const& from) {
    scene.integration.engine = "reference";
    return make_simulation(scene, from, std::string(backend_name<Space>));
  }

  static Simulations each_alone(Scene const& scene, std::vector<Snapshot> const& from) {
    Simulations all;
    for (auto const& snapshot : from) all.push_back(alone(scene, snapshot));
    return all;
  }

  /// All to the end of the sampling, in turn, so many steps at a time.
  static std::vector<OpenWindows> run(Simulations const& all, Sampling const& sampling,
                                      std::int64_t steps) {
    std::vector<OpenWindows> windows(all.size());
    for (auto stop = all[0]->step(); stop < sampling.last_step;) {
      stop = std::min(stop + steps, sampling.last_step);
      for (std::size_t s = 0; s < all.size(); ++s)
        all[s]->advance(stop - all[s]->step(), sampling, windows[s]);
    }
    return windows;
  }

  template <class Repulsion = HarmonicRepulsion>
  static void expect_same(Scene const& scene, int systems, Sampling const& sampling,
                          std::int64_t steps, int threads = 0) {
    auto const from = starts(scene, systems);
    auto const members = together<Repulsion>(scene, from, threads);
    auto const singles = each_alone(scene, from);
    auto const a = run(members, sampling, steps), b = run(singles, sampling, steps);
    for (std::size_t s = 0; s < members.size(); ++s) {
      expect_equal(*members[s], *singles[s]);
      expect_equal(a[s], b[s]);
      EXPECT_GE(singles[s]->snapshot().list_builds, 3) << "too short to cross a list build";
    }
  }
};

TYPED_TEST_SUITE(EnsembleOf, EveryLawOnEveryBackendByEveryScheme, TypeNames);

TYPED_TEST(EnsembleOf, HasTheBitsOfEachAlone) {
  for (double const packing_fraction : {0.84, 0.55})
    TestFixture::expect_same(TestFixture::scene(packing_fraction), 3, {200, 7, 500}, 500);
}

TYPED_TEST(EnsembleOf, HasThemInBoxesThatAreNotSquare) {
  for (double const aspect : {4.0, 0.25}) {
    Scene scene = TestFixture::scene(0.84);
    scene.disks.box_aspect = aspect;
    TestFixture::expect_same(scene, 2, {200, 7, 300}, 300);
  }
}

TYPED_TEST(EnsembleOf, HasThemUnderHertz) {
  Scene scene = TestFixture::scene();
  scene.disks.force_exponent = 2.5;
  scene.disks.mass = "equal";
  TestFixture::template expect_same<HertzianRepulsion>(scene, 2, {200, 7, 300}, 300);
}

/// Where the strain rate changes every five steps, in one advance and in pieces.
TYPED_TEST(EnsembleOf, HasThemOnRamps) {
  for (double const packing_fraction : {0.84, 0.55}) {
    Scene scene = TestFixture::scene(packing_fraction);
    scene.integration.skin = 0.3;
    ramp_every_five_steps(scene);
    scene.shear.strain = 50 * 5e-3 * scene.shear.ramp_every / 5;
    Ramp const ramp = make_ramp(scene);
    auto const steps = packing_fraction > 0.8 ? ramp.steps() : 33;
    TestFixture::expect_same(scene, 3, {ramp.window_steps, 7, ramp.steps()}, steps);
  }
}

/// More disks than fit into the scratch of a host's team, and several of MeasureBlock's blocks.
TYPED_TEST(EnsembleOf, HasThemOutOfScratch) {
  constexpr std::int64_t count = 1200;
  using Kernel = typename TestFixture::Kernel;
  using Policy = typename Kernel::Policy;
  EXPECT_LT(Kernel::scratch_size(64), static_cast<std::size_t>(Policy::scratch_size_max(0)));
  if (!is_device<typename TestFixture::Space>) {
    EXPECT_GT(Kernel::scratch_size(count), static_cast<std::size_t>(Policy::scratch_size_max(0)));
  }
  TestFixture::expect_same(TestFixture::scene(0.82, count), 2, {50, 7, 63}, 7);
}

/// Boxes of a single cell, where all pairs are searched.
TYPED_TEST(EnsembleOf, HasThemInTheSmallestBoxes) {
  Scene scene = TestFixture::scene(0.80, 16);
  scene.integration.skin = 0.25;
  TestFixture::expect_same(scene, 3, {100, 10, 300}, 300);
}

/// Lists longer than there is room for at first.
TYPED_TEST(EnsembleOf, MakesRoomForLongLists) {
  Scene scene = TestFixture::scene(0.84, 300);
  scene.integration.skin = 1.2;
  auto const from = TestFixture::starts(scene, 2);
  auto const members = TestFixture::together(scene, from);
  auto const singles = TestFixture::each_alone(scene, from);
  Sampling const sampling{100, 10, 100};
  auto const a = TestFixture::run(members, sampling, 100);
  auto const b = TestFixture::run(singles, sampling, 100);
  for (std::size_t s = 0; s < 2; ++s) {
    expect_equal(*members[s], *singles[s]);
    expect_equal(a[s], b[s]);
  }
}

TYPED_TEST(EnsembleOf, DoesNotDependOnHowAdvancesAreCut) {
  Scene const scene = TestFixture::scene(0.82);
  auto const from = TestFixture::starts(scene, 3);
  Sampling const sampling{200, 1, 450};  // more samples than a launch has room for
  auto const straight = TestFixture::together(scene, from);
  auto const pieces = TestFixture::together(scene, from);
  auto const a = TestFixture::run(straight, sampling, 450);
  auto const b = TestFixture::run(pieces, sampling, 13);
  for (std::size_t s = 0; s < 3; ++s) {
    expect_equal(*straight[s], *pieces[s]);
    expect_equal(a[s], b[s]);
    ASSERT_EQ(a[s].sums.size(), 3u);
    EXPECT_EQ(a[s].sums[0].weight, 200);
    EXPECT_EQ(a[s].sums[2].weight, 50);
  }
}

/// Also where systems had come to different steps.
TYPED_TEST(EnsembleOf, GoesOnFromSnapshots) {
  Scene const scene = TestFixture::scene(0.82, 150);
  auto const from = TestFixture::starts(scene, 2);
  Sampling const sampling{200, 7, 400};
  auto const singles = TestFixture::each_alone(scene, from);
  auto const expected = TestFixture::run(singles, sampling, 400);
  std::vector<OpenWindows> windows(2);
  std::vector<Snapshot> at = from;
  for (std::size_t s = 0; s < 2; ++s) {
    auto const one = TestFixture::alone(scene, from[s]);
    one->advance(30 + 40 * static_cast<std::int64_t>(s), sampling, windows[s]);
    at[s] = one->snapshot();
  }
  for (std::int64_t stop : {61, 170, 400}) {
    auto const members = TestFixture::together(scene, at);
    for (std::size_t s = 0; s < 2; ++s)
      expect_equal(*members[s], *TestFixture::alone(scene, at[s]));
    for (std::size_t s = 0; s < 2; ++s)
      if (at[s].step < stop) members[s]->advance(stop - at[s].step, sampling, windows[s]);
    for (std::size_t s = 0; s < 2; ++s) at[s] = members[s]->snapshot();
    if (stop < 400) continue;
    for (std::size_t s = 0; s < 2; ++s) {
      expect_equal(*members[s], *singles[s]);
      expect_equal(windows[s], expected[s]);
    }
  }
}

/// A system that fails says what it says alone; the others go on.
TYPED_TEST(EnsembleOf, AFailureIsThatOfItsSystem) {
  Scene const scene = TestFixture::scene();
  auto const good = TestFixture::starts(scene, 3);
  auto deep = good, fast = good, no_number = good;
  deep[1].state.position[5] = deep[1].state.position[40];
  deep[1].state.position[5][0] += 0.3;
  fast[1].state.velocity[7][1] = 100;
  no_number[1].state.velocity[3][0] = std::nan("");
  auto const what = [](auto const& act) -> std::string {
    try {
      act();
    } catch (NumericalError const& error) {
      return error.what();
    }
    return "no error";
  };
  for (auto const& from : {deep, fast, no_number}) {
    std::string const expected = what([&] { advance(*TestFixture::alone(scene, from[1]), 20); });
    EXPECT_NE(expected.find("disk"), std::string::npos) << expected;
    auto const members = TestFixture::together(scene, from);
    advance(*members[0], 20);
    EXPECT_EQ(what([&] { advance(*members[1], 20); }), expected);
    EXPECT_EQ(what([&] { advance(*members[1], 0); }), expected) << "it is not over";
    advance(*members[2], 20);
    for (std::size_t const s : {0u, 2u}) {
      auto const single = TestFixture::alone(scene, from[s]);
      advance(*single, 20);
      expect_equal(*members[s], *single);
    }
  }
}

TYPED_TEST(EnsembleOf, AMemberLeftBehindHasNoSnapshot) {
  Scene const scene = TestFixture::scene();
  auto const members = TestFixture::together(scene, TestFixture::starts(scene, 2));
  advance(*members[0], 10);
  EXPECT_EQ(members[1]->step(), 0);
  EXPECT_THROW(members[1]->snapshot(), std::logic_error);
  advance(*members[1], 10);
  EXPECT_EQ(members[1]->snapshot().step, 10);
}

/// Threads of a team share a system's disks.
TYPED_TEST(EnsembleOf, DoesNotDependOnThreadsOfATeam) {
  using Kernel = typename TestFixture::Kernel;
  if (typename Kernel::Policy(1, 1).team_size_max(Kernel{}, Kokkos::ParallelForTag{}) < 2)
    GTEST_SKIP() << "teams of one thread";
  TestFixture::expect_same(TestFixture::scene(), 3, {200, 7, 300}, 300, 2);
}

}  // namespace bagnold::test
