// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <gtest/gtest.h>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

/// P1 Sec. II C: dt = min{0.5/Q, 0.1, 0.2 Q}.
TEST(PaperTimeStep, OfP1) {
  for (auto const* model : {"CD_n", "general"}) {
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.1)), 0.02);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.5)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 1)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 5)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 50)), 0.01);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 500)), 0.001);
  }
}

/// P2 Sec. II D: 0.05; below Q = 0.5 down to 0.01.
TEST(PaperTimeStep, OfP2) {
  for (auto const* model : {"CD", "CD_rot"}) {
    for (double const q : {0.5, 1.0, 50.0, 1e4}) EXPECT_EQ(paper_time_step(disks(model, q)), 0.05);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.3)), 0.03);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.1)), 0.01);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.001)), 0.01);
  }
}

TEST(TimeStep, AsGivenOrThePapers) {
  Scene scene = minimal_scene();
  EXPECT_EQ(time_step(scene), 0.05);
  scene.integration.time_step = 0.0123;
  EXPECT_EQ(time_step(scene), 0.0123);
}

}  // namespace
}  // namespace bagnold
