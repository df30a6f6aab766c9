// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace bagnold {
namespace {

/// Whether the script is still being written when such a Python ends is chance, so it is drawn
/// often.
TEST(Plot, OutlivesAPythonThatReadsNothing) {
  setenv("BAGNOLD_PYTHON", "/bin/true", 1);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(draw_plot("no_result.h5", "no_picture.png"), "");
  unsetenv("BAGNOLD_PYTHON");
}

}  // namespace
}  // namespace bagnold
