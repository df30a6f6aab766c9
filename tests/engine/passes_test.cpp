// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/cpu/steps/block_stepper.hpp"
#include "src/engine/law_engines.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

std::unique_ptr<BlockStepper> stepper(Scene const& scene) {
  return engines_for(scene.disks.model).stepper(engine_input(scene));
}

/// Blocks that the passes of a step await, if they are more than the block itself.
std::vector<Awaits> awaited(BlockPasses const& passes, bool sampled) {
  std::vector<Awaits> list;
  for (auto const& pass : passes)
    if (pass->belongs(sampled) && pass->facts.awaits != Awaits::own)
      list.push_back(pass->facts.awaits);
  return list;
}

std::ptrdiff_t count(BlockPasses const& passes, bool sampled) {
  return std::ranges::count_if(passes, [=](auto const& pass) { return pass->belongs(sampled); });
}

class Passes : public testing::TestWithParam<std::string> {};

TEST_P(Passes, OfExplicitSchemesAwaitNeighboursAlone) {
  using enum Awaits;
  Scene scene = small_scene(GetParam());
  for (std::string const scheme : {"two-stage-leapfrog", "modified-velocity-verlet"}) {
    SCOPED_TRACE(scheme);
    scene.integration.scheme = scheme;
    auto const of = stepper(scene);
    for (auto const* passes : {&of->many, &of->few}) {
      EXPECT_EQ(awaited(*passes, true), (std::vector{neighbours, neighbours}));
      EXPECT_EQ(awaited(*passes, false), (std::vector{neighbours, neighbours}));
      EXPECT_EQ((*passes)[0]->facts.awaits, neighbours);
    }
    EXPECT_EQ(of->evaluations(), scheme == "two-stage-leapfrog" ? 1 : 2);
    EXPECT_NE(of->lone_pairs, nullptr);
  }
}

/// A step of n terms has n - 1 iterations; the last is a pass of its own where sums are taken.
TEST_P(Passes, OfImplicitDampingAwaitAllBlocks) {
  using enum Awaits;
  Scene scene = small_scene(GetParam());
  scene.integration.scheme = "implicit-damping";
  auto const of = stepper(scene);
  auto const iterations = static_cast<std::size_t>(ImplicitDamping::terms(scene.rotates()) - 1);
  std::vector<Awaits> expected(1 + iterations, all);
  expected.front() = neighbours;
  EXPECT_EQ(awaited(of->many, false), expected);
  expected.push_back(all);  // sums need the last iterate of neighbours
  EXPECT_EQ(awaited(of->many, true), expected);
  EXPECT_EQ(count(of->many, true) - count(of->many, false), 2);
  EXPECT_TRUE(of->few.empty());
  EXPECT_EQ(of->lone_pairs, nullptr);
}

TEST_P(Passes, AreThoseOfAllDisksUnderADrive) {
  Scene scene = small_scene(GetParam());
  scene.drive.kind = "stokes";
  scene.drive.drag = 0.1;
  auto const of = stepper(scene);
  EXPECT_TRUE(of->uses(Uses::drive));
  scene.drive.kind = "none";
  auto const without = stepper(scene);
  EXPECT_FALSE(without->uses(Uses::drive));
  for (bool const sampled : {false, true})  // the force, the second stage, and their powers
    EXPECT_EQ(count(of->many, sampled) - count(without->many, sampled), sampled ? 3 : 2);
  EXPECT_TRUE(of->few.empty());
  EXPECT_EQ(of->lone_pairs, nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, Passes, testing::ValuesIn(law_names()));

}  // namespace
}  // namespace bagnold::test
