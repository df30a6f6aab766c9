// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bagnold {
namespace {

TEST(Band, SitsWhereTheSlopeIsLargest) {
  double const L = 37.0;
  for (double const centre : {0.0, 5.0, 18.5, 31.7, 36.9}) {
    std::vector<double> excess;  // its derivative is cos(2 pi (y - centre)/L)
    for (int b = 0; b < 24; ++b)
      excess.push_back(0.3 * std::sin(2 * std::numbers::pi * ((b + 0.5) / 24 - centre / L)));
    EXPECT_NEAR(std::remainder(band_position(excess, L) - centre, L), 0.0, 1e-12);
  }
}

/// 1 outside, 0 in the band, straight flanks one bin wide.
std::vector<double> well(int n, int first, int last) {
  std::vector<double> profile(static_cast<std::size_t>(n), 1.0);
  for (int b = first; b <= last; ++b) profile[static_cast<std::size_t>(((b % n) + n) % n)] = 0.0;
  return profile;
}

TEST(Band, ShareOfAWell) {
  // bottom: 5 bins, 4 steps between them, and of either flank the part below the level
  EXPECT_NEAR(share_below(well(20, 3, 7), 0.25), (4 + 2 * 0.25) / 20, 1e-15);
  EXPECT_NEAR(share_below(well(20, 3, 7), 0.75), (4 + 2 * 0.75) / 20, 1e-15);
  EXPECT_NEAR(share_below(well(20, -2, 2), 0.5), 5.0 / 20, 1e-15)
      << "across the edge of the period";
}

TEST(Band, ShareOfNothingAndAll) {
  std::vector<double> const flat(10, 0.8);
  EXPECT_EQ(share_below(flat, 0.7), 0.0);
  EXPECT_EQ(share_below(flat, 0.9), 1.0);
  EXPECT_EQ(share_below(flat, 0.8), 0.0);
  EXPECT_TRUE(std::isnan(share_below(std::vector{0.5, std::nan(""), 0.5}, 0.8)));
}

TEST(Band, MeanWhereItShearsFastest) {
  for (int const first : {3, 15}) {  // an eighth: two bins, the other time across the edge
    auto phi = well(16, first, first + 3), rate = phi;
    for (double& value : rate) value = 1 - value;
    for (int const b : {first, (first + 1) % 16}) rate[static_cast<std::size_t>(b)] = 1.5;
    phi[static_cast<std::size_t>((first + 1) % 16)] = 0.5;
    EXPECT_EQ(in_fastest_band(rate, rate), 1.5) << first;
    EXPECT_EQ(in_fastest_band(rate, phi), 0.25) << first;
    for (double& value : rate) value *= -1;
    EXPECT_EQ(in_fastest_band(rate, phi), 1.0) << first;
  }
  std::vector const some{1.0, 2.0}, none{1.0, std::nan("")};
  EXPECT_TRUE(std::isnan(in_fastest_band(some, none)));
  EXPECT_TRUE(std::isnan(in_fastest_band(none, some)));
}

}  // namespace
}  // namespace bagnold
