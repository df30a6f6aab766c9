// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_blocks.hpp"

#include <cmath>

#include "src/config/laws.hpp"
#include "src/engine/events/event_engine.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/events.hpp"
#include "tests/support/ramps.hpp"

/// Blocks that go alone, beside one queue: the same bits.
namespace bagnold::test {
namespace {

constexpr std::uint32_t group = 32;
constexpr std::uint32_t one_queue = 0;

/// The engine of a scene whose disks go by blocks of a size, with halos of a depth, on two threads;
/// or all by one queue.
std::unique_ptr<Simulation> in_blocks(Scene const& scene, Snapshot const& snapshot,
                                      std::uint32_t size, int depth = 2) {
  auto const constants = law_of(scene.disks).constants(scene.disks);
  auto const table = make_species_table(scene.mass_by_area());
  events::BlockPlan const plan{
      size == one_queue ? nullptr : make_block_loop(backend_names().back()), size, group, depth};
  auto const make = [&]<bool rotates>() -> std::unique_ptr<Simulation> {
    return std::make_unique<EventEngine<rotates>>(
        events::Material<rotates>::of({constants.normal, constants.tangential}, table),
        strain_rates(scene), time_step(scene), skin(scene), snapshot, plan);
  };
  return scene.rotates() ? make.template operator()<true>() : make.template operator()<false>();
}

Scene scene_of(std::string const& law, double packing_fraction, double elasticity, double rate) {
  Scene scene = dilute_scene(law, packing_fraction, 1024, elasticity);
  scene.shear.strain_rate = rate;
  return scene;
}

std::int64_t steps_of(Scene const& scene, double strain) {
  return std::llround(strain / (scene.shear.strain_rate * time_step(scene)));
}

void expect_same(Simulation const& a, Simulation const& b, std::string const& where) {
  auto const one = a.snapshot(), other = b.snapshot();
  EXPECT_TRUE(one.state.position == other.state.position) << where;
  EXPECT_TRUE(one.state.velocity == other.state.velocity) << where;
  EXPECT_TRUE(one.state.spin == other.state.spin) << where;
  EXPECT_TRUE(one.arrays == other.arrays) << where;
  EXPECT_EQ(one.memory, other.memory) << where;
  EXPECT_EQ(one.counters, other.counters) << where;
  EXPECT_EQ(one.list_builds, other.list_builds) << where;
}

void expect_same(OpenWindows const& a, OpenWindows const& b, std::string const& where) {
  ASSERT_EQ(a.sums.size(), b.sums.size()) << where;
  for (std::size_t w = 0; w < a.sums.size(); ++w) {
    EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << where << " " << w;
    EXPECT_EQ(a.sums[w].weight, b.sums[w].weight) << where << " " << w;
  }
}

class EventBlocks : public testing::TestWithParam<std::string> {};

}  // namespace

/// Where most fly, where clusters are common, and where they are so large that blocks give up.
TEST_P(EventBlocks, HaveTheBitsOfOneQueue) {
  struct Of {
    double packing_fraction, elasticity, rate, strain;
  };
  for (auto const& of : {Of{0.6, 50, 1e-5, 0.1}, Of{0.78, 50, 1e-5, 0.03}, Of{0.78, 1, 1e-5, 0.004},
                         Of{0.82, 50, 1e-5, 0.01}, Of{0.82, 50, 1e-4, 0.004}}) {
    Scene const scene = scene_of(GetParam(), of.packing_fraction, of.elasticity, of.rate);
    auto const start = first_snapshot(flying_start(scene));
    auto const steps = steps_of(scene, of.strain);
    Sampling const sampling{steps / 3, 1, steps};
    auto const one = in_blocks(scene, start, one_queue);
    OpenWindows expected;
    one->advance(steps, sampling, expected);
    EXPECT_GT(one->snapshot().counters.at("collisions"), 500);
    for (std::uint32_t const size : {group, 4 * group}) {
      auto const where = std::to_string(of.packing_fraction) + " " + std::to_string(of.elasticity) +
                         " " + std::to_string(size);
      auto const blocks = in_blocks(scene, start, size);
      OpenWindows windows;
      blocks->advance(steps, sampling, windows);
      expect_same(*one, *blocks, where);
      expect_same(expected, windows, where);
    }
  }
}

TEST_P(EventBlocks, HaveThemWhereRunsAreCut) {
  Scene const scene = scene_of(GetParam(), 0.78, 20, 1e-5);
  auto const start = first_snapshot(flying_start(scene));
  auto const steps = steps_of(scene, 0.02);
  Sampling const sampling{steps / 3, 1, steps};
  auto const one = in_blocks(scene, start, one_queue);
  auto blocks = in_blocks(scene, start, 2 * group);
  OpenWindows expected, windows;
  one->advance(steps, sampling, expected);
  for (int k = 0; blocks->step() < steps; ++k) {
    blocks->advance(1 + steps / 30 * (k % 5), sampling, windows);
    auto const size = k % 4 == 0 ? one_queue : group << (k % 3);
    blocks = in_blocks(scene, blocks->snapshot(), size, 3);
  }
  expect_same(*one, *blocks, "cut");
  expect_same(expected, windows, "cut");
}

/// All go by one queue there.
TEST_P(EventBlocks, HaveThemWhereContactsAreWatched) {
  Scene scene = scene_of(GetParam(), 0.78, 20, 1e-5);
  scene.measure.contacts = true;
  auto const start = first_snapshot(flying_start(scene));
  auto const steps = steps_of(scene, 0.004);
  auto const watched = [&](std::uint32_t size) {
    auto simulation = in_blocks(scene, start, size);
    OpenWindows windows;
    windows.contacts = std::make_shared<ContactRecord>(1024, simulation->columns(), 0, nullptr);
    simulation->advance(steps, {steps / 3, 1, steps}, windows);
    return std::pair(std::move(simulation), std::move(windows));
  };
  auto const one = watched(one_queue), blocks = watched(4 * group);
  expect_same(*one.first, *blocks.first, "watched");
  expect_same(one.second, blocks.second, "watched");
}

TEST_P(EventBlocks, HaveThemInRamps) {
  Scene scene = dilute_scene(GetParam(), 0.78, 1024, 10);
  ramp_by_time_units(scene);
  auto const start = first_snapshot(flying_start(scene));
  Ramp const ramp = make_ramp(scene);
  Sampling const sampling{ramp.window_steps, 1, ramp.steps()};
  auto const one = in_blocks(scene, start, one_queue), blocks = in_blocks(scene, start, 4 * group);
  OpenWindows expected, windows;
  one->advance(ramp.steps(), sampling, expected);
  blocks->advance(ramp.steps(), sampling, windows);
  EXPECT_GT(one->snapshot().counters.at("carried_contacts"), 100);
  expect_same(*one, *blocks, "ramp");
  expect_same(expected, windows, "ramp");
}

INSTANTIATE_TEST_SUITE_P(All, EventBlocks, testing::Values("CD_n", "CD_rot"),
                         [](auto const& info) { return info.param; });

}  // namespace bagnold::test
