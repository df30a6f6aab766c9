// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/errors.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

constexpr char const* engines[] = {"reference", "few-contacts", "many-contacts", "lookahead"};

Scene scene_for(std::string const& engine) {
  Scene scene = small_scene("CD_rot", 0.80, 300);
  scene.integration.engine = engine;
  return scene;
}

/// What an engine leaves behind after 300 steps. That of the reference engine has the form of a
/// device's.
Snapshot left_by(std::string const& engine, State const& start) {
  auto const simulation = simulate(scene_for(engine), start, "serial");
  advance(*simulation, 300);
  return simulation->snapshot();
}

/// No engine needs more of another than where the disks are and how they move.
TEST(Resume, AnyEngineGoesOnFromAnyOther) {
  State const start = shaken_start(scene_for("reference"));
  auto const straight = simulate(scene_for("reference"), start, "serial");
  advance(*straight, 500);
  for (auto const* from : engines) {
    Snapshot const left = left_by(from, start);
    ASSERT_FALSE(left.list_position.empty());
    for (auto const* to : engines) {
      auto const resumed = make_simulation(scene_for(to), left, "serial");
      EXPECT_EQ(resumed->step(), 300);
      advance(*resumed, 200);
      EXPECT_LT(largest_difference(resumed->state(), straight->state(), 1e-2), 1e-11)
          << from << " to " << to;
    }
  }
}

/// Bits depend on all of the memory: a part of it is no reason to guess the rest.
TEST(Resume, RefusesAPartOfTheMemory) {
  Snapshot whole = left_by("many-contacts", shaken_start(scene_for("reference")));
  for (auto const& [name, value] : whole.memory) {
    Snapshot part = whole;
    part.memory.erase(name);
    try {
      make_simulation(scene_for("many-contacts"), part, "serial");
      ADD_FAILURE() << "went on without " << name;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

/// Bits depend on no counter; one that an older version did not have begins at 0.
TEST(Resume, CountsFromZeroWhatWasNotCounted) {
  auto const scene = scene_for("many-contacts");
  Snapshot const whole = left_by("many-contacts", shaken_start(scene));
  ASSERT_GT(whole.counters.at("prunings"), 0);
  Snapshot without = whole;
  without.counters.clear();
  auto const a = make_simulation(scene, whole, "serial");
  auto const b = make_simulation(scene, without, "serial");
  advance(*a, 100);
  advance(*b, 100);
  EXPECT_EQ(a->state().position, b->state().position);
  EXPECT_EQ(a->snapshot().memory, b->snapshot().memory);
  for (auto const& [name, value] : b->snapshot().counters)
    EXPECT_EQ(value, a->snapshot().counters.at(name) - whole.counters.at(name)) << name;
}

}  // namespace
}  // namespace bagnold::test
