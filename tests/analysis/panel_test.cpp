// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/panel.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bagnold::analysis {
namespace {

Outcome at(std::string const& phi, double place) {
  Outcome one;
  one.labels = {{"disks.packing_fraction", phi}};
  one.found.value = {place};
  one.found.error = {0.1};
  return one;
}

/// A table that grew has its packing fractions in the order of the runs.
TEST(DrawAgainstLabel, GoesByTheLabelNotByTheOrderOfRuns) {
  Report report;
  auto failed = at("0.78", unknown);
  failed.failure = "not found";
  draw_against_label(report, {at("0.8", 45), at("0.76", 23), failed, at("0.82", 100)}, {{0}}, "Q_c",
                     true);
  std::vector<std::string> x, y;
  for (auto const& row : report.drawn.rows) x.push_back(row.at(7)), y.push_back(row.at(9));
  EXPECT_EQ(x, (std::vector<std::string>{"0.76", "0.8", "0.82"}));
  EXPECT_EQ(y, (std::vector<std::string>{"23", "45", "100"}));
}

}  // namespace
}  // namespace bagnold::analysis
