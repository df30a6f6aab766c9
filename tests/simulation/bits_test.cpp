// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/simulations.hpp"

namespace bagnold::test {

/// Equality to the last bit.
class Bits : public EverySimulation {
 public:
  Scene scene() const { return small_scene(0.82, 300); }

  static void expect_equal(State const& a, State const& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.spin, b.spin);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.time, b.time);
  }
};

TEST_P(Bits, DoNotDependOnTheBackend) {
  State const state = shaken_start(scene());
  auto const one = simulate(scene(), state, backend());
  auto const first = simulate(scene(), state, backend_names().front());
  WindowSums a, b;
  one->advance(500, {0, 7}, a);
  first->advance(500, {0, 7}, b);
  expect_equal(one->state(), first->state());
  EXPECT_EQ(a.sums, b.sums);
}

/// With more patches than threads.
TEST_P(Bits, OfManyDisksDoNotDependOnTheBackend) {
  Scene const scene = small_scene(0.82, 5000);
  State const state = shaken_start(scene);
  auto const one = simulate(scene, state, backend());
  auto const first = simulate(scene, state, backend_names().front());
  WindowSums a, b;
  one->advance(60, {0, 7}, a);
  first->advance(60, {0, 7}, b);
  expect_equal(one->state(), first->state());
  EXPECT_EQ(a.sums, b.sums);
}

TEST_P(Bits, DoNotDependOnSamplingOrOnHowAdvancesAreCut) {
  State const state = shaken_start(scene());
  auto const straight = simulate(scene(), state, backend());
  auto const pieces = simulate(scene(), state, backend());
  auto const silent = simulate(scene(), state, backend());
  WindowSums a, b;
  straight->advance(500, {0, 7}, a);
  for (std::int64_t steps : {1, 2, 13, 84, 100, 300}) pieces->advance(steps, {0, 7}, b);
  advance(*silent, 500);
  expect_equal(straight->state(), pieces->state());
  expect_equal(straight->state(), silent->state());
  EXPECT_EQ(a.sums, b.sums);
  EXPECT_EQ(a.weight, b.weight);
}

TEST_P(Bits, GoOnFromASnapshot) {
  auto straight = simulate(scene(), shaken_start(scene()), backend());
  auto chained = simulate(scene(), shaken_start(scene()), backend());
  advance(*straight, 700);
  for (int link = 0; link < 7; ++link) {  // 100 steps are no multiple of the list's life
    advance(*chained, 100);
    chained = make_simulation(scene(), chained->snapshot(), backend());
  }
  EXPECT_GT(straight->snapshot().list_builds, 7);
  EXPECT_EQ(straight->snapshot().list_builds, chained->snapshot().list_builds);
  EXPECT_EQ(straight->snapshot().list_position, chained->snapshot().list_position);
  expect_equal(straight->snapshot().state, chained->snapshot().state);
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

}  // namespace bagnold::test
