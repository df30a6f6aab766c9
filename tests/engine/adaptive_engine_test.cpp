// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/abilities.hpp"
#include "src/config/events.hpp"
#include "src/config/plan.hpp"
#include "src/config/schemes.hpp"
#include "src/engine/events/event_choice.hpp"
#include "tests/support/events.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

Scene adaptive_scene(double packing_fraction, double rate, double elasticity,
                     std::int64_t count = 100) {
  Scene scene = small_scene("CD_n", packing_fraction, count);
  scene.disks.elasticity = elasticity;
  scene.shear.strain_rate = rate;
  scene.integration.scheme = automatic;
  scene.integration.engine = automatic;
  scene.integration.time_step = automatic;
  return scene;
}

/// From where disks fly to where they touch and back.
Scene crossing_ramp() {
  Scene scene = adaptive_scene(0.6, 1e-4, 5);
  auto& shear = scene.shear;
  shear.protocol = "ramp";
  shear.strain_rate_high = 2e-2;
  shear.ramp_every = 1;
  shear.ramp_window = 100;
  shear.ramp_rate = std::log10(200) / 4000;
  shear.strain = 0.1;  // before it
  shear.cycles = 1;
  return scene;
}

constexpr std::int64_t window = 500, every = 10, end = 40000;
constexpr std::int64_t stretch = 4096;  // between choices

constexpr std::int64_t many_disks = 8192;  // which have several threads

double by_events(Simulation const& simulation) {
  auto const counters = simulation.counters();
  return counters.contains("steps_by_events") ? counters.at("steps_by_events") : -1;
}

void expect_same(Simulation const& one, OpenWindows const& a, Simulation const& other,
                 OpenWindows const& b) {
  EXPECT_EQ(one.state().position, other.state().position);
  EXPECT_EQ(one.state().velocity, other.state().velocity);
  ASSERT_EQ(a.sums.size(), b.sums.size());
  for (std::size_t w = 0; w < a.sums.size(); ++w) {
    EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << w;
    EXPECT_EQ(a.sums[w].weight, b.sums[w].weight) << w;
  }
}

/// A run in one call, and one in many, of which each goes on from a checkpoint; and windows of
/// both.
struct StraightAndChained {
  /// backend(k): of call k of the second one.
  template <class Backend>
  StraightAndChained(Scene const& scene, std::int64_t end, std::int64_t cut,
                     Backend const& backend) {
    State const start = flying_start(scene);
    straight = test::simulate(scene, start, "serial");
    chained = test::simulate(scene, start, backend(0));
    Sampling const sampling{window, every, end};
    straight->advance(end, sampling, a);
    for (int k = 0; chained->step() < end; ++k) {
      chained->advance(1 + cut * (k % 5), sampling, b);
      chained = make_simulation(scene, chained->snapshot(), backend(k + 1));
    }
  }
  StraightAndChained(Scene const& scene, std::int64_t end)
      : StraightAndChained(scene, end, 197, [](int) { return "serial"; }) {}

  void expect_the_same() const {
    expect_same(*straight, a, *chained, b);
    auto const memory = straight->snapshot().memory, other = chained->snapshot().memory;
    EXPECT_EQ(memory.size(), other.size());
    for (auto const& [name, number] : memory) EXPECT_EQ(number, other.at(name)) << name;
    EXPECT_EQ(straight->snapshot().arrays, chained->snapshot().arrays);
    EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
  }

  std::unique_ptr<Simulation> straight, chained;
  OpenWindows a, b;
};

}  // namespace

TEST(AdaptiveEngine, TakesEventsWhereDisksFlyAndStepsWhereTheyTouch) {
  auto const run = [](Scene const& scene) {
    auto simulation = test::simulate(scene, flying_start(scene), "serial");
    OpenWindows windows;
    simulation->advance(end, {window, every, end}, windows);
    for (auto const& of : windows.sums) EXPECT_NEAR(of.weight, window / every, 1e-9);
    return simulation;
  };
  EXPECT_EQ(by_events(*run(adaptive_scene(0.6, 1e-4, 20))), end - stretch);
  EXPECT_EQ(by_events(*run(adaptive_scene(0.84, 1e-3, 1))), 0);
}

/// Many contacts cost a comparison at each choice, and no bit.
TEST(AdaptiveEngine, StepsAreThoseOfStepsAlone) {
  Scene scene = adaptive_scene(0.84, 1e-3, 1);
  State const start = flying_start(scene);
  Sampling const sampling{window, every, end};
  OpenWindows a, b;
  auto const chosen = test::simulate(scene, start, "serial");
  scene.integration.engine = steps_engine;
  auto const steps = test::simulate(scene, start, "serial");
  chosen->advance(end, sampling, a);
  steps->advance(end, sampling, b);
  EXPECT_EQ(by_events(*chosen), 0);
  EXPECT_EQ(by_events(*steps), -1);
  expect_same(*chosen, a, *steps, b);
}

/// Contacts of Q = 1 gather in clusters.
TEST(AdaptiveEngine, BitsDoNotDependOnCutsOrRestarts) {
  StraightAndChained const both(adaptive_scene(0.7, 1e-4, 1), end);
  EXPECT_GT(by_events(*both.straight), 0);
  both.expect_the_same();
}

TEST(AdaptiveEngine, NorDoThoseOfARampAcrossWhereContactsAreMany) {
  Scene const scene = crossing_ramp();
  auto const steps = make_plan(scene).steps;
  StraightAndChained const both(scene, steps);
  both.expect_the_same();
  auto const simulation = test::simulate(scene, flying_start(scene), "serial");
  std::vector<bool> turns{false};
  while (simulation->step() < steps) {
    OpenWindows windows;
    auto const before = by_events(*simulation);
    simulation->advance(stretch, {window, every, steps}, windows);
    bool const now = by_events(*simulation) > before;
    if (now != turns.back()) turns.push_back(now);
  }
  EXPECT_EQ(turns, (std::vector{false, true, false, true}));
}

/// Events are tried and given up; blocks of both are on several threads.
TEST(AdaptiveEngine, ManyDisksCrossWithTheirBitsOnAnyThreads) {
  auto const on_threads_too = [](int k) {
    return k % 4 == 2 ? backend_names().back() : std::string("serial");
  };
  Scene const scene = adaptive_scene(0.77, 1e-4, 5, many_disks);
  StraightAndChained const both(scene, 2 * stretch + 200, 397, on_threads_too);
  both.expect_the_same();
  EXPECT_EQ(by_events(*both.straight), stretch);
}

/// Of as many collisions a disk, few disks bear more than many.
TEST(AdaptiveEngine, ManyDisksLeaveEventsEarlier) {
  events::EventChoice const few(many_disks - 2), many(many_disks);
  for (auto const* of : {&few, &many}) {
    EXPECT_FALSE(of->leaves(0.008 * 1e6, 1e6));
    EXPECT_TRUE(of->leaves(0.018 * 1e6, 1e6));
  }
  EXPECT_FALSE(few.leaves(0.012 * 1e6, 1e6));
  EXPECT_TRUE(many.leaves(0.012 * 1e6, 1e6));
}

TEST(AdaptiveEngine, LeavesToStepsWhatEventsCannotDo) {
  auto const goes_by_turns = [](auto const& change) {
    Scene scene = adaptive_scene(0.6, 1e-4, 20);
    change(scene);
    EXPECT_TRUE(why_not(scene).empty());
    return may_take_events(scene);
  };
  EXPECT_TRUE(goes_by_turns([](Scene&) {}));
  EXPECT_TRUE(goes_by_turns([](Scene& s) { s.disks.count = many_disks; }));
  EXPECT_TRUE(goes_by_turns([](Scene& s) { s = resolved(s); }));
  EXPECT_TRUE(goes_by_turns([](Scene& s) { s = resolved(crossing_ramp()); }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.measure.contacts = true; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.disks.force_exponent = 2.5; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.disks.elasticity = 0.5; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.integration.engine = steps_engine; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.integration.scheme = papers_scheme; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.integration.time_step = 0.1; }));
  EXPECT_FALSE(goes_by_turns([](Scene& s) { s.integration.time_step = of_papers; }));
}

/// A checkpoint of steps alone, as of a version without this choice.
TEST(AdaptiveEngine, GoesOnByStepsWhereOneOfStepsStopped) {
  Scene scene = adaptive_scene(0.6, 1e-4, 20);
  scene.integration.engine = steps_engine;
  auto const steps = test::simulate(scene, flying_start(scene), "serial");
  Sampling const sampling{window, every, end};
  OpenWindows a, b;
  steps->advance(2 * stretch, sampling, a);
  scene.integration.engine = automatic;
  auto const resumed = make_simulation(scene, steps->snapshot(), "serial");
  b = a;
  steps->advance(end, sampling, a);
  resumed->advance(end, sampling, b);
  expect_same(*steps, a, *resumed, b);
}

}  // namespace bagnold::test
