// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/windows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bagnold::statistics {
namespace {

Windows three() {
  Windows windows{2, {}, {}};
  windows.push_back(std::array{1.0, 10.0}, 1.0);
  windows.push_back(std::array{6.0, 20.0}, 2.0);
  windows.push_back(std::array{5.0, 0.0}, 5.0);
  return windows;
}

TEST(Windows, MeansAreSumsOverWeights) {
  Windows const windows = three();
  EXPECT_EQ(windows.size(), 3u);
  EXPECT_EQ(windows.row(1)[0], 6.0);
  EXPECT_EQ(windows.mean(0, 3), (std::vector{12.0 / 8.0, 30.0 / 8.0}));
  EXPECT_EQ(windows.mean(1, 2), (std::vector{3.0, 10.0}));
}

TEST(Windows, NoWindowHasNoMean) {
  EXPECT_TRUE(std::isnan(three().mean(1, 1)[0]));
  EXPECT_THROW(three().mean(0, 4), std::out_of_range);
}

TEST(Windows, RefusesWhatIsNoWindow) {
  Windows windows = three();
  EXPECT_THROW(windows.push_back(std::array{1.0}, 1.0), std::invalid_argument);
  EXPECT_THROW(windows.push_back(std::array{1.0, 2.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(windows.push_back(std::array{1.0, 2.0}, std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
  EXPECT_EQ(windows.size(), 3u);
  EXPECT_EQ(windows.sums.size(), 6u);
}

}  // namespace
}  // namespace bagnold::statistics
