// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/errors.hpp"
#include "src/config/skin.hpp"
#include "src/engine/reference/reference_engine.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/equal.hpp"
#include "tests/support/simulations.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

void expect_equal(Listener const& a, Listener const& b) {
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t k = 0; k < a.all.size(); ++k) {
    EXPECT_EQ(a.all[k].key(), b.all[k].key());
    EXPECT_EQ(a.all[k].theta, b.all[k].theta);
  }
  auto const numbers = [](ContactVelocities const& v) {
    return std::tuple(v.tangential, v.rotational, v.normal);
  };
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    EXPECT_EQ(a.samples[k].pair, b.samples[k].pair);
    EXPECT_EQ(numbers(a.samples[k].velocities), numbers(b.samples[k].velocities));
  }
  ASSERT_EQ(a.picks.size(), b.picks.size());
  for (auto one = a.picks.begin(), other = b.picks.begin(); one != a.picks.end(); ++one, ++other) {
    EXPECT_EQ(one->first, other->first);
    EXPECT_EQ(numbers(one->second), numbers(other->second));
  }
}

}  // namespace

/// Steps queued without the host between them, and disks sorted in memory: the same bits.
template <class On>
class LaunchPlanOf : public testing::Test {
 public:
  using Law = typename On::Law;
  using Engine = ReferenceEngine<Law, HarmonicRepulsion, typename On::Space, typename On::Scheme>;

  static Scene scene(double packing_fraction, std::int64_t count) {
    Scene scene = small_scene(std::string(Law::name), packing_fraction, count);
    scene.integration.scheme = On::Scheme::name;
    if (TwoStageScheme<typename On::Scheme>) scene.integration.time_step = 0.2;
    return scene;
  }

  static Scene ramp() {
    Scene scene = LaunchPlanOf::scene(0.84, 100);
    scene.integration.skin = 0.3;
    ramp_every_five_steps(scene);
    return scene;
  }

  static Engine engine(Scene const& scene, Snapshot const& from, LaunchPlan const& plan) {
    return {make_law<Law>(scene.disks),
            make_species_table(scene.mass_by_area()),
            strain_rates(scene),
            time_step(scene),
            skin(scene),
            from,
            nullptr,
            plan};
  }

  /// One to the end of the sampling at one go, the others so many steps at a time, each piece from
  /// the snapshot of the one before.
  static void expect_same_bits(Scene const& scene, Sampling const& sampling, std::int64_t piece) {
    Snapshot const start = first_snapshot(shaken_start(scene));
    auto plain = engine(scene, start, {});
    OpenWindows expected;
    plain.advance(sampling.last_step, sampling, expected);
    EXPECT_GE(plain.snapshot().list_builds, 3) << "too short to cross a list build";
    for (auto const& plan : {LaunchPlan{1, true}, LaunchPlan{7, false}, LaunchPlan{32, true}}) {
      SCOPED_TRACE(testing::Message() << plan.queued << " queued, sorts " << plan.sorts);
      Snapshot at = start;
      OpenWindows windows;
      while (at.step < sampling.last_step) {
        auto one = engine(scene, at, plan);
        one.advance(piece, sampling, windows);
        at = one.snapshot();
      }
      expect_equal(engine(scene, at, plan), plain);
      expect_equal(windows, expected);
    }
  }

  static std::string failure_of(Scene const& scene, Snapshot const& from, LaunchPlan const& plan) {
    try {
      auto one = engine(scene, from, plan);
      advance(one, 20);
    } catch (NumericalError const& error) {
      return error.what();
    }
    return "no error";
  }
};

/// A law with spins and one without, by every scheme.
template <class... On>
auto of_two_laws(testing::Types<On...> const*)
    -> decltype(std::tuple_cat(std::conditional_t<std::is_same_v<typename On::Law, CDn> ||
                                                      std::is_same_v<typename On::Law, CDrot>,
                                                  std::tuple<On>, std::tuple<>>{}...));
using TwoLaws = decltype(detail::as_types(
    static_cast<decltype(of_two_laws(
        static_cast<EveryLawOnEveryBackendByEveryScheme const*>(nullptr))) const*>(nullptr)));
TYPED_TEST_SUITE(LaunchPlanOf, TwoLaws, TypeNames);

TYPED_TEST(LaunchPlanOf, ChangesNoBit) {
  for (double const packing_fraction : {0.84, 0.55})
    TestFixture::expect_same_bits(TestFixture::scene(packing_fraction, 100), {150, 7, 300}, 300);
}

TYPED_TEST(LaunchPlanOf, ChangesNoBitFromSnapshots) {
  TestFixture::expect_same_bits(TestFixture::scene(0.82, 100), {150, 3, 300}, 47);
}

/// Sums are added in three levels of groups.
TYPED_TEST(LaunchPlanOf, ChangesNoBitOfManyDisks) {
  TestFixture::expect_same_bits(TestFixture::scene(0.80, 5000), {60, 11, 60}, 60);
}

TYPED_TEST(LaunchPlanOf, ChangesNoBitOfRamps) {
  Scene const scene = TestFixture::ramp();
  Ramp const ramp = make_ramp(scene);
  Snapshot const start = first_snapshot(shaken_start(scene));
  Sampling const sampling{ramp.window_steps, 7, ramp.steps()};
  auto plain = TestFixture::engine(scene, start, {});
  auto queued = TestFixture::engine(scene, start, {32, true});
  OpenWindows expected, windows;
  plain.advance(ramp.steps(), sampling, expected);
  queued.advance(ramp.steps(), sampling, windows);
  expect_equal(queued, plain);
  expect_equal(windows, expected);
}

/// Contacts are followed within a queue too, from piece to piece, and where disks change places.
TYPED_TEST(LaunchPlanOf, ChangesNoContact) {
  for (double const packing_fraction : {0.84, 0.60}) {
    Scene const scene = TestFixture::scene(packing_fraction, 100);
    Sampling const sampling{150, 7, 600};
    Snapshot const start = first_snapshot(shaken_start(scene));
    auto plain = TestFixture::engine(scene, start, {});
    Observed expected(plain, 100, 0, SampleChoice(11));
    plain.advance(sampling.last_step, sampling, expected.windows);
    EXPECT_GT(expected.listener->all.size(), 20u);
    EXPECT_GT(expected.listener->samples.size(), 10u);
    EXPECT_GT(expected.listener->picks.size(), 100u);
    for (std::int64_t const piece : {600, 47}) {
      auto one = std::make_unique<typename TestFixture::Engine>(
          TestFixture::engine(scene, start, {32, true}));
      Observed observed(*one, 100, 0, SampleChoice(11));
      while (one->step() < sampling.last_step) {
        one->advance(piece, sampling, observed.windows);
        one = std::make_unique<typename TestFixture::Engine>(
            TestFixture::engine(scene, one->snapshot(), {32, true}));
      }
      expect_equal(observed.windows, expected.windows);
      expect_equal(*observed.listener, *expected.listener);
    }
  }
}

/// Velocities are over the rate of their step, also where a queue at the next rate is under way
/// when the record is told of them.
TYPED_TEST(LaunchPlanOf, ChangesNoContactOfRamps) {
  Scene const scene = TestFixture::ramp();
  Ramp const ramp = make_ramp(scene);
  Snapshot const start = first_snapshot(shaken_start(scene));
  Sampling const sampling{ramp.window_steps, 7, ramp.steps()};
  auto plain = TestFixture::engine(scene, start, {});
  auto queued = TestFixture::engine(scene, start, {32, true});
  Observed expected(plain, 100, 0, SampleChoice(11)), observed(queued, 100, 0, SampleChoice(11));
  plain.advance(ramp.steps(), sampling, expected.windows);
  queued.advance(ramp.steps(), sampling, observed.windows);
  EXPECT_GT(expected.listener->picks.size(), 100u);
  expect_equal(observed.windows, expected.windows);
  expect_equal(*observed.listener, *expected.listener);
}

/// With the step, the disk of the start and the number that a failure has without a queue.
TYPED_TEST(LaunchPlanOf, ChangesNoWordOfAFailure) {
  Scene const scene = TestFixture::scene(0.82, 64);
  Snapshot const good = first_snapshot(shaken_start(scene));
  auto deep = good, fast = good, no_number = good;
  deep.state.position[5] = deep.state.position[40];
  deep.state.position[5][0] += 0.3;
  fast.state.velocity[7][1] = 100;
  no_number.state.velocity[3][0] = std::nan("");
  for (auto const& from : {deep, fast, no_number}) {
    std::string const expected = TestFixture::failure_of(scene, from, {});
    EXPECT_NE(expected.find("disk"), std::string::npos) << expected;
    EXPECT_EQ(TestFixture::failure_of(scene, from, {32, false}), expected);
    EXPECT_EQ(TestFixture::failure_of(scene, from, {32, true}), expected);
  }
}

}  // namespace bagnold::test
