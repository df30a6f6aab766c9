// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/rotation.hpp"

#include <gtest/gtest.h>

#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

TEST(Rotation, DensityOfKnownSpins) {
  State state = test::square_lattice(2, 2.0, 1e-2);
  state.spin = {-0.005 + 1e-5, -0.005 + 1e-5, 0.25, -3.0};  // over gammadot: -0.499 twice, 25, -300
  Rotation first, rotation;
  first.add({state, 0, 0.0});
  ObserverState numbers;
  first.save(numbers);
  rotation.load(numbers);
  rotation.add({state, 1, 0.1});
  FrameResults results;
  rotation.report({&rotation}, results);
  auto const& h = test::named(results.histograms, "rotation");
  auto const share = [&](double value) {
    for (std::size_t b = 0; b < h.density.size(); ++b)
      if (h.edges[b] <= value && value < h.edges[b + 1])
        return h.density[b] * (h.edges[b + 1] - h.edges[b]);
    return -1.0;
  };
  EXPECT_NEAR(share(-0.499), 0.5, 1e-12);
  EXPECT_NEAR(share(25.0), 0.25, 1e-12);
  EXPECT_NEAR(share(-300.0), 0.25, 1e-12);
  double total = 0;
  for (std::size_t b = 0; b < h.density.size(); ++b)
    total += h.density[b] * (h.edges[b + 1] - h.edges[b]);
  EXPECT_NEAR(total, 1.0, 1e-12);
}

TEST(Counts, WhatLiesBeyondCountsInTheTotalOnly) {
  Counts counts(even_edges(0.0, 1.0, 2));
  for (double const value : {-1.0, 0.0, 0.5, 1.0, std::nan("")}) counts.add(value);
  auto const h = counts.histogram("x", "1", "");
  EXPECT_EQ(h.density, (std::vector{0.5, 0.5})) << "one of four in each half, a half wide";
}

}  // namespace
}  // namespace bagnold
