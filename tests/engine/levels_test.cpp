// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/levels/levels.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kernels/cpu/simd/level.hpp"
#include "src/config/errors.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// BAGNOLD_SIMD while a test lasts.
class Asked {
 public:
  explicit Asked(char const* level) {
    if (auto const* before = std::getenv(name)) before_ = before;
    setenv(name, level, 1);
  }
  ~Asked() { before_.empty() ? unsetenv(name) : setenv(name, before_.c_str(), 1); }

 private:
  static constexpr char const* name = "BAGNOLD_SIMD";
  std::string before_;
};

TEST(Levels, TheOneAskedForRuns) {
  for (auto const& level : levels()) {
    if (!level.here) continue;
    Asked const asked(std::string(level.name).c_str());
    EXPECT_EQ(chosen_level().name, level.name);
    EXPECT_EQ(level_of("CD_rot", no_drive).name, level.name);
  }
}

TEST(Levels, TheFirstOfThisProcessorRunsWhereNoneIsAskedFor) {
  Asked const asked("");
  for (auto const& level : levels())
    if (level.here) {
      EXPECT_EQ(chosen_level().name, level.name);
      break;
    }
}

TEST(Levels, OthersAreRefused) {
  Asked const asked("mmx");
  EXPECT_THROW(chosen_level(), InputError);
}

/// Packs of different levels differ in size: what a program compiles itself goes with all else.
TEST(Levels, RegisteredLawsAndDrivesGoWithEverythingElse) {
  for (auto const& level : levels()) {
    if (!level.here) continue;
    Asked const asked(std::string(level.name).c_str());
    EXPECT_EQ(level_of("CD_rot", "wind").name, simd::level_name);
    EXPECT_EQ(level_of("CD_rot", "stokes").name, level.name);
    EXPECT_EQ(level_of("CD_x", "stokes").name, simd::level_name);
  }
}

}  // namespace
}  // namespace bagnold::test
