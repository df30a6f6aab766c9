// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/type_list.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/equal.hpp"

namespace bagnold::test {

/// Equality to the last bit.
class Bits : public EverySimulation {
 public:
  Scene scene() const { return small_scene(0.82, 300); }

  /// test(scene) with either scheme.
  template <class Test>
  void for_schemes(Scene scene, Test const& test) const {
    for (auto const scheme : names_of<Schemes>()) {
      SCOPED_TRACE(scheme);
      scene.integration.scheme = scheme;
      test(scene);
    }
  }

  /// Steps on, with either scheme, on this backend and on the first one.
  void expect_those_of_the_first_backend(Scene const& start, std::int64_t steps) const {
    State const state = shaken_start(start);
    for_schemes(start, [&](Scene const& scene) {
      auto const one = simulate(scene, state, backend());
      auto const first = simulate(scene, state, backend_names().front());
      auto const a = advance(*one, steps, 7);
      auto const b = advance(*first, steps, 7);
      expect_equal(one->state(), first->state());
      EXPECT_EQ(a.sums, b.sums);
    });
  }
};

TEST_P(Bits, DoNotDependOnTheBackend) { expect_those_of_the_first_backend(scene(), 500); }

/// With more patches than threads.
TEST_P(Bits, OfManyDisksDoNotDependOnTheBackend) {
  expect_those_of_the_first_backend(small_scene(0.82, 5000), 60);
}

TEST_P(Bits, DoNotDependOnSamplingOrOnHowAdvancesAreCut) {
  State const state = shaken_start(scene());
  for_schemes(scene(), [&](Scene const& scene) {
    auto const straight = simulate(scene, state, backend());
    auto const pieces = simulate(scene, state, backend());
    auto const silent = simulate(scene, state, backend());
    Sampling sampling{200, 7, 500};
    OpenWindows a, b;
    straight->advance(500, sampling, a);
    for (std::int64_t steps : {1, 2, 13, 84, 100, 300}) {
      pieces->advance(steps, sampling, b);
      pieces->give_back_scratch();
    }
    advance(*silent, 500);
    expect_equal(straight->state(), pieces->state());
    expect_equal(straight->state(), silent->state());
    ASSERT_EQ(a.sums.size(), 3u);
    ASSERT_EQ(b.sums.size(), 3u);
    for (int w = 0; w < 3; ++w) {
      EXPECT_EQ(a.sums[w].sums, b.sums[w].sums);
      EXPECT_EQ(a.sums[w].weight, w < 2 ? 29 : 15);
      EXPECT_EQ(a.sums[w].weight, b.sums[w].weight);
    }
  });
}

TEST_P(Bits, GoOnFromASnapshot) {
  auto const test = [&](Scene const& scene) {
    auto straight = simulate(scene, shaken_start(scene), backend());
    auto chained = simulate(scene, shaken_start(scene), backend());
    Sampling const sampling{200, 7, 700};
    OpenWindows a, b;
    straight->advance(700, sampling, a);
    int links = 0;
    for (; chained->step() < 700; ++links) {  // 100 steps are no multiple of the list's life
      chained->advance(100, sampling, b);
      chained = make_simulation(scene, chained->snapshot(), backend());
    }
    EXPECT_GE(links, 6);
    EXPECT_GT(straight->snapshot().list_builds, 7);
    EXPECT_EQ(straight->snapshot().list_builds, chained->snapshot().list_builds);
    EXPECT_EQ(straight->snapshot().list_position, chained->snapshot().list_position);
    EXPECT_EQ(straight->snapshot().memory, chained->snapshot().memory);
    EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
    expect_equal(straight->snapshot().state, chained->snapshot().state);
    ASSERT_EQ(a.sums.size(), b.sums.size());
    for (std::size_t w = 0; w < a.sums.size(); ++w) EXPECT_EQ(a.sums[w].sums, b.sums[w].sums);
  };
  for (double packing_fraction : {0.82, 0.55})
    for_schemes(small_scene(packing_fraction, 300), test);
}

/// How often lists are built must not be seen in the trajectory beyond the rounding of wraps.
TEST_P(Bits, ListsDoNotActOnTheTrajectory) {
  Scene wide = scene();
  wide.integration.skin = 0.6;
  State const state = shaken_start(scene());
  auto const narrow_list = simulate(scene(), state, backend());
  auto const wide_list = simulate(wide, state, backend());
  advance(*narrow_list, 300);
  advance(*wide_list, 300);
  EXPECT_GT(narrow_list->snapshot().list_builds, 2 * wide_list->snapshot().list_builds);
  EXPECT_LT(largest_difference(narrow_list->state(), wide_list->state(), scene().shear.strain_rate),
            1e-12);
}

BAGNOLD_FOR_EVERY_SIMULATION(Bits);

/// Dense steps are many-contacts ones to the last bit while they have the same lists.
class DenseBits : public testing::TestWithParam<std::string> {};

TEST_P(DenseBits, AreThoseOfContactRichSteps) {
  for (auto const scheme : explicit_schemes())
    for (double packing_fraction : {0.60, 0.82}) {
      Scene scene = small_scene(GetParam(), packing_fraction, 3000);
      scene.shear.strain_rate = 1e-3;
      scene.integration.skin = 0.5;
      scene.integration.scheme = scheme;
      State state = shaken_start(scene);
      for (auto& v : state.velocity) v[1] -= 0.1;  // no common drift: one list for all steps
      scene.integration.engine = "many-contacts";
      auto const rich = simulate(scene, state, "serial");
      scene.integration.engine = "few-contacts";
      auto const dense = simulate(scene, state, "serial");
      auto const a = advance(*rich, 80, 3), b = advance(*dense, 80, 3);
      EXPECT_EQ(rich->snapshot().list_builds, 1);
      EXPECT_EQ(dense->snapshot().list_builds, 1);
      EXPECT_EQ(dense->snapshot().counters.at("steps_few_contacts"), 80);
      EXPECT_EQ(rich->snapshot().counters.at("steps_few_contacts"), 0);
      expect_equal(rich->state(), dense->state());
      EXPECT_EQ(a.sums, b.sums);
      EXPECT_GT(a.sums[SumColumns::contacts], 0);
    }
}

INSTANTIATE_TEST_SUITE_P(All, DenseBits, testing::ValuesIn(law_names()),
                         [](auto const& info) { return info.param; });

/// Disks on a square lattice, shaken, small and big ones by turns: many touch.
State shaken_lattice(Scene const& scene) {
  State state;
  auto const side = std::lround(std::sqrt(static_cast<double>(scene.disks.count)));
  state.box_length = scene.box_length();
  state.offset = state.box_length / 3;
  state.strain_rate = scene.shear.strain_rate;
  double const spacing = state.box_length / static_cast<double>(side);
  for (long k = 0; k < side * side; ++k) {
    double const t = static_cast<double>(k);
    double const y = spacing * (static_cast<double>(k / side) + 0.5 + 0.02 * std::cos(78.233 * t));
    state.position.push_back(
        {spacing * (static_cast<double>(k % side) + 0.5 + 0.02 * std::sin(12.9898 * t)), y});
    state.velocity.push_back(
        {scene.shear.strain_rate * y + 0.02 * std::sin(4.1 * t), 0.1 + 0.02 * std::cos(5.3 * t)});
    state.spin.push_back(0.02 * std::sin(2.7 * t));
    state.diameter.push_back((k + k / side) % 3 == 0 ? small_diameter : big_diameter);
  }
  return state;
}

/// Systems that do not fit into cache go through both halves of a step block by block. Where
/// contacts are recorded all blocks go through the first half before any goes through the second.
TEST(LargeBits, DependNeitherOnTheOrderOfBlocksNorOnTheBackend) {
  Scene scene = small_scene("CD_rot", 0.65, 320 * 320);
  scene.integration.skin = 0.35;
  State const state = shaken_lattice(scene);
  for (auto const engine : {"many-contacts", "few-contacts"})
    for (auto const scheme : names_of<Schemes>()) {
      SCOPED_TRACE(std::string(engine) + ", " + std::string(scheme));
      scene.integration.engine = engine;
      scene.integration.scheme = scheme;
      auto const whole = simulate(scene, state, backend_names().front());
      Sampling sampling{1000, 4, whole->step() + 12};
      Observed at_once(*whole, state.count());
      whole->advance(12, sampling, at_once.windows);
      auto sums = at_once.windows.take_first().sums;
      EXPECT_GT(sums.at(SumColumns::contacts), 1e5);
      sums.resize(static_cast<std::size_t>(whole->columns()));  // without those of contacts
      for (auto const& backend : backend_names()) {
        auto const in_rows = simulate(scene, state, backend);
        EXPECT_EQ(advance(*in_rows, 12, 4).sums, sums);
        expect_equal(in_rows->state(), whole->state());
      }
    }
}

}  // namespace bagnold::test
