// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bagnold::test {
namespace {

/// SplitMix64 from the state 1234567, as its authors' program prints it.
TEST(Mixed, IsSplitMix64) {
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15u;
  EXPECT_EQ(mixed(1234567), 6457827717110365317u);
  EXPECT_EQ(mixed(1234567 + step), 3203168211198807973u);
  EXPECT_EQ(mixed(1234567 + 2 * step), 9817491932198370423u);
}

TEST(RandomStream, IsEvenAndOfItsOwn) {
  RandomStream const noise(Stream::thermal_noise, 1), samples(Stream::contact_samples, 1),
      other(Stream::thermal_noise, 2);
  constexpr int count = 20000;
  double mean = 0, square = 0, with_samples = 0, with_other = 0, with_next = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    double const u = noise.uniform(k, 7);
    ASSERT_GT(u, 0);
    ASSERT_LE(u, 1);
    mean += u / count;
    square += u * u / count;
    with_samples += (u - 0.5) * (samples.uniform(k, 7) - 0.5) * 12 / count;
    with_other += (u - 0.5) * (other.uniform(k, 7) - 0.5) * 12 / count;
    with_next += (u - 0.5) * (noise.uniform(k, 8) - 0.5) * 12 / count;
  }
  double const error = 1 / std::sqrt(double(count));  // of a correlation coefficient
  EXPECT_NEAR(mean, 0.5, 4 * error / std::sqrt(12.0));
  EXPECT_NEAR(square, 1.0 / 3, 4 * error * 0.3);
  for (double const correlation : {with_samples, with_other, with_next})
    EXPECT_NEAR(correlation, 0, 4 * error);
}

}  // namespace
}  // namespace bagnold::test
