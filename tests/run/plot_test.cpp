// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "src/run/python_package.hpp"

namespace bagnold {
namespace {

TEST(Plot, IsWhatThePythonSays) {
  setenv("BAGNOLD_PYTHON", "/bin/true", 1);
  EXPECT_EQ(draw_plot("no_result.h5", "no_picture.png"), "");
  setenv("BAGNOLD_PYTHON", "/bin/false", 1);
  EXPECT_NE(draw_plot("no_result.h5", "no_picture.png"), "");
  unsetenv("BAGNOLD_PYTHON");
}

TEST(PythonPackage, HasAnAbsolutePathAndHoldsThePackage) {
  auto const source = std::string(BAGNOLD_SOURCE_FOLDER) + "/python";
  setenv("BAGNOLD_PYTHON_PACKAGE", source.c_str(), 1);
  EXPECT_EQ(python_package(), source);
  EXPECT_EQ(wrong_python_package(), "");
  for (auto const* wrong : {"", "python", "./python", "/"}) {
    setenv("BAGNOLD_PYTHON_PACKAGE", wrong, 1);
    EXPECT_EQ(python_package(), "") << wrong;
    EXPECT_NE(wrong_python_package().find("absolute"), std::string::npos) << wrong;
  }
  unsetenv("BAGNOLD_PYTHON_PACKAGE");
  EXPECT_EQ(wrong_python_package(), "");
}

}  // namespace
}  // namespace bagnold
