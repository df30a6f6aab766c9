// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/physics/sums/sums.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Sums of the same configurations: as many contacts, and all else to 1e-9 of what it is made of.
inline void expect_equal_sums(WindowSums const& sums, WindowSums const& expected) {
  using C = SumColumns;
  EXPECT_EQ(sums.sums[C::contacts], expected.sums[C::contacts]);
  double const kinetic = expected.sums[C::kinetic_xx] + expected.sums[C::kinetic_yy];
  double const elastic = expected.sums[C::elastic_xx] + expected.sums[C::elastic_yy];
  ASSERT_EQ(sums.sums.size(), expected.sums.size());
  for (std::size_t c = 0; c < sums.sums.size(); ++c) {
    double const scale = c < C::kinetic_xx ? elastic : kinetic;
    EXPECT_NEAR(sums.sums[c], expected.sums[c], 1e-9 * (std::abs(expected.sums[c]) + scale)) << c;
  }
}

}  // namespace bagnold
