// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "src/analysis/fit/line.hpp"
#include "src/analysis/kinds/kinds.hpp"
#include "src/statistics/student.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

/// A line through points whose errors are told `told` times as large as they are; 0: not at all.
Outcome line_through(std::size_t points, double told, std::mt19937_64& random) {
  auto made = sampled(
      evenly(0.0, 1.0, static_cast<int>(points)), [](double x) { return 1.0 + 2.0 * x; },
      [](double) { return 0.1; }, &random);
  if (told == 0.0) made.error.clear();
  for (double& error : made.error) error *= told;
  Task const task{{}, [made](std::uint32_t) {
                    auto const line = fit_line(made);
                    FitResult out{line.value, line.error, line.chi2, line.freedom, made.size()};
                    out.weighted = made.weighted();
                    return out;
                  }};
  Request request;
  request.resamples = 0;
  return carry_out({task}, request).front();
}

/// Where chi2 is far beyond chance errors are those of the scatter: two of them hold the truth as
/// often as they should, from few degrees of freedom too.
TEST(ScatterErrors, HoldTheTruthWhereErrorsOfPointsAreFarTooSmall) {
  std::mt19937_64 random(43);
  int const sets = 2000;
  for (double const told : {0.0, 0.02})
    for (std::size_t const points : {5, 8, 20}) {
      int inside = 0;
      for (int set = 0; set < sets; ++set) {
        auto const found = line_through(points, told, random).found;
        inside += std::abs(found.value[1] - 2.0) <= 2.0 * found.error[1];
      }
      EXPECT_NEAR(inside / static_cast<double>(sets), 0.9545, 0.02) << points << " " << told;
    }
}

TEST(ScatterErrors, AreTold) {
  std::mt19937_64 random(44);
  auto const poor = line_through(12, 0.05, random), good = line_through(12, 1.0, random);
  double const scale = std::sqrt(poor.found.chi2 / 10.0);
  EXPECT_GT(scale, 10.0);
  EXPECT_DOUBLE_EQ(poor.found.widened, scale * statistics::student_factor(10));
  EXPECT_DOUBLE_EQ(good.found.widened, 1.0);
  auto const table = tabulate({poor, good}, {"a", "b"});
  auto const column = std::ranges::find(table.columns, "widened") - table.columns.begin();
  EXPECT_EQ(table.rows[0][static_cast<std::size_t>(column)], cell(poor.found.widened));
  EXPECT_EQ(table.rows[1][static_cast<std::size_t>(column)], "");
  Report report;
  note_fits(report, {poor, good}, {"a", "b"});
  ASSERT_EQ(report.notes.size(), 2);
  EXPECT_NE(report.notes[0].find("chi2 is beyond chance in 1 of 2 fits"), std::string::npos);
  EXPECT_NE(report.notes[1].find("widened"), std::string::npos);
}

}  // namespace
}  // namespace bagnold::analysis
