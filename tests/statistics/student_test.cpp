// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/student.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bagnold::statistics {
namespace {

/// Critical values of tables, two-sided 95% and 99%: half of their last digit, 5e-4, changes the
/// probability by less than 6e-5 from two degrees of freedom on.
TEST(Student, ProbabilitiesAreThoseOfTables) {
  struct Row {
    std::size_t freedom;
    double at_95, at_99;
  };
  for (Row const row : {Row{1, 12.706, 63.657},
                        {2, 4.303, 9.925},
                        {3, 3.182, 5.841},
                        {4, 2.776, 4.604},
                        {5, 2.571, 4.032},
                        {10, 2.228, 3.169},
                        {30, 2.042, 2.750}}) {
    EXPECT_NEAR(student_probability(row.at_95, row.freedom), 0.95, 6e-5) << row.freedom;
    EXPECT_NEAR(student_probability(row.at_99, row.freedom), 0.99, 6e-5) << row.freedom;
  }
}

TEST(Student, FactorMakesTwoErrorsTheIntervalOfTwoStandardDeviations) {
  for (std::size_t freedom : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 31u, 1000u})
    EXPECT_NEAR(student_probability(2.0 * student_factor(freedom), freedom),
                std::erf(std::numbers::sqrt2), 1e-12);
  EXPECT_NEAR(student_factor(3), 1.6534, 1e-4);
  EXPECT_NEAR(student_factor(100000), 1.0, 1e-4);
}

}  // namespace
}  // namespace bagnold::statistics
