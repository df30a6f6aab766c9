// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "src/engine/sampling.hpp"
#include "src/engine/simulation.hpp"

/// Equal to the last bit.
namespace bagnold::test {

inline void expect_equal(State const& a, State const& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(a.diameter, b.diameter);
  EXPECT_EQ(a.box_length, b.box_length);
  EXPECT_EQ(a.box_aspect, b.box_aspect);
  EXPECT_EQ(a.offset, b.offset);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.strain_rate, b.strain_rate);
}

/// With its lists.
inline void expect_equal(Simulation const& one, Simulation const& other) {
  Snapshot const a = one.snapshot(), b = other.snapshot();
  expect_equal(a.state, b.state);
  EXPECT_EQ(a.list_position, b.list_position);
  EXPECT_EQ(a.list_step, b.list_step);
  EXPECT_EQ(a.list_builds, b.list_builds);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(one.state().position, other.state().position);
}

inline void expect_equal(OpenWindows const& a, OpenWindows const& b) {
  ASSERT_EQ(a.sums.size(), b.sums.size());
  for (std::size_t w = 0; w < a.sums.size(); ++w) {
    EXPECT_EQ(a.sums[w].sums, b.sums[w].sums);
    EXPECT_EQ(a.sums[w].weight, b.sums[w].weight);
  }
}

}  // namespace bagnold::test
