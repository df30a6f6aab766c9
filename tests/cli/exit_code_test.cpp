// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/exit_code.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>

#include "src/config/errors.hpp"

namespace bagnold {
namespace {

template <class Failure>
int code_of(Failure const& failure) {
  return exit_code_of(std::make_exception_ptr(failure));
}

TEST(ExitCode, IsThatOfTheKindOfFailure) {
  EXPECT_EQ(code_of(InputError("x")), 2);
  EXPECT_EQ(code_of(NumericalError("x")), 3);
  EXPECT_EQ(code_of(FileError("x")), 4);
  EXPECT_EQ(code_of(std::filesystem::filesystem_error("x", std::error_code())), 4);
  EXPECT_EQ(code_of(std::bad_alloc()), 2);
}

TEST(ExitCode, OfListsThatCannotHoldThePairsNamesTheKeys) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(code_of(std::length_error("too many disks for one process")), 2);
  auto const said = testing::internal::GetCapturedStderr();
  for (auto const* word : {"too many disks", "disks.count", "integration.skin", "fewer"})
    EXPECT_NE(said.find(word), std::string::npos) << said;
}

TEST(ExitCode, OfWhatNobodyForesawIsAnInternalErrorToBeReported) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(code_of(std::out_of_range("vector::at")), 5);
  auto const said = testing::internal::GetCapturedStderr();
  for (auto const* word : {"internal error", "vector::at", "report"})
    EXPECT_NE(said.find(word), std::string::npos) << said;
  EXPECT_EQ(code_of(7), 5);
}

}  // namespace
}  // namespace bagnold
