// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kernels/cpu/steps/block_stepper.hpp"
#include "src/engine/law_engines.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

std::unique_ptr<BlockStepper> stepper(Scene const& scene) {
  return engines_for(scene.disks.model).stepper(engine_input(scene));
}

/// What passes await, of a step that is sampled or of another.
std::vector<Awaits> awaited(BlockPasses const& passes, bool sampled) {
  std::vector<Awaits> list;
  for (auto const& pass : passes)
    if (sampled || !pass->sampled) list.push_back(pass->awaits);
  return list;
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
      EXPECT_EQ(awaited(*passes, true), (std::vector{neighbours, neighbours, own}));
      EXPECT_EQ(awaited(*passes, false), (std::vector{neighbours, own}));
    }
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
  expected.insert(expected.end(), {all, own});
  EXPECT_EQ(awaited(of->many, true), expected);
  EXPECT_EQ(awaited(of->many, false).size(), expected.size() - 2);
  EXPECT_TRUE(of->few.empty());
  EXPECT_EQ(of->lone_pairs, nullptr);
}

TEST_P(Passes, AreThoseOfAllDisksUnderADrive) {
  Scene scene = small_scene(GetParam());
  scene.drive.kind = "stokes";
  scene.drive.drag = 0.1;
  auto const of = stepper(scene);
  EXPECT_EQ(of->many.size(), 3u);
  EXPECT_TRUE(of->few.empty());
  EXPECT_EQ(of->lone_pairs, nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, Passes, testing::ValuesIn(law_names()));

}  // namespace
}  // namespace bagnold::test
