// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/stated.hpp"

#include <gtest/gtest.h>

namespace bagnold::analysis::test {

nlohmann::json entry(nlohmann::json const& more) {
  nlohmann::json made{{"what", "x"}, {"source", "here"}, {"column", "x"}, {"stated", 1.0}};
  made.update(more);
  return made;
}

Rows const rows{{"disks.elasticity", "x", "x_error"},
                {{"1", "1.5", "0.3"}, {"10", "0.8", ""}, {"100", "", ""}}};

std::vector<std::string> deviations(nlohmann::json const& more) {
  std::vector<std::string> out;
  for (auto const& one : compare(entry(more), rows)) out.push_back(one.deviation);
  return out;
}

TEST(Stated, DeviatesInStandardErrorsOfBoth) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(deviations({{"row", {{"disks.elasticity", 1}}}}), Texts{"+1.7 standard errors"});
  EXPECT_EQ(deviations({{"row", {{"disks.elasticity", 1}}}, {"error", 0.4}}),
            Texts{"+1.0 standard errors"});
  EXPECT_EQ(deviations(nlohmann::json::object()), (Texts{"+1.7 standard errors", "-", "-"}));
}

TEST(Stated, RangesAreMissedByTheDistanceToThem) {
  nlohmann::json const first{{"disks.elasticity", 1}};
  EXPECT_EQ(deviations({{"row", first}, {"stated", {1.0, 2.0}}})[0], "inside");
  EXPECT_EQ(deviations({{"row", first}, {"stated", {1.3, 1.6}}})[0], "inside, our error is wider");
  EXPECT_EQ(deviations({{"row", first}, {"stated", {1.8, 2.0}}})[0], "-1.0 standard errors");
  EXPECT_EQ(deviations({{"row", first}, {"stated", {0.6, 0.9}}})[0], "+2.0 standard errors");
}

/// 1.5 +- 0.3, 0.8 without an error, nothing.
TEST(Stated, TellsWhatAgrees) {
  auto const agree = [](nlohmann::json const& more) {
    std::string out;
    for (auto const& one : compare(entry(more), rows)) out += one.agrees + ";";
    return out;
  };
  EXPECT_EQ(agree(nlohmann::json::object()), "yes;no;;");
  EXPECT_EQ(agree({{"stated", 0.8}}), "no;yes;;");
  EXPECT_EQ(agree({{"stated", 0.8}, {"error", 0.2}}), "yes;yes;;");  // 1.9 errors of both
  EXPECT_EQ(agree({{"stated", 0.8}, {"error", 0.2}, {"about", true}}), "no;yes;;");  // 2.3 of ours
  // 1.5 +- 0.3 is 0.7 off, 2.2 errors beyond 0.05 and 1.7 beyond 0.2; 0.8 has no error, but rounds
  EXPECT_EQ(agree({{"stated", 0.8}, {"about", 0.05}}), "no;yes;;");
  EXPECT_EQ(agree({{"stated", 0.8}, {"about", 0.2}}), "yes;yes;;");
  EXPECT_EQ(agree({{"stated", 0.9}, {"about", 0.05}}), "yes;no;;");
  EXPECT_EQ(agree({{"stated", 0.9}, {"about", 0.15}}), "yes;yes;;");
  EXPECT_EQ(agree({{"stated", {0.7, 0.85}}}), "no;yes;;");
  EXPECT_EQ(agree({{"stated", {1.0, 2.0}}}), "yes;no;;");
  EXPECT_EQ(agree({{"stated", {1.3, 1.6}}}), "untold;no;;");  // our error is wider
}

/// A fit that was found and leaves a parameter out says that data do not tell it.
TEST(Stated, SaysWhatIsNotTold) {
  Rows const fits{{"phi", "x", "x_error", "failure"},
                  {{"0.8", "1.5", "0.3", ""}, {"0.83", "", "", ""}, {"0.9", "", "", "2 points"}}};
  auto const found = compare(entry(nlohmann::json::object()), fits);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].ours, "1.5 +- 0.3");
  EXPECT_EQ(found[1].ours, "not told");
  EXPECT_EQ(found[1].agrees, "");
  EXPECT_EQ(found[2].ours, "not found");
}

TEST(Stated, SaysWhatIsNotFound) {
  auto const missing = compare(entry({{"row", {{"disks.elasticity", 100}}}}), rows);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].ours, "not found");
  EXPECT_EQ(compare(entry({{"column", "y"}}), rows)[0].ours, "not found");
  auto const absent = compare(entry({{"row", {{"disks.elasticity", 7}}}}), rows);
  ASSERT_EQ(absent.size(), 1u);
  EXPECT_EQ(absent[0].ours, "not found");
  EXPECT_EQ(missing[0].what, "x");
  EXPECT_EQ(compare(entry(nlohmann::json::object()), rows)[1].what,
            "x, Q = 10");  // rows told apart
  EXPECT_EQ(compare(entry({{"about", true}}), rows)[0].stated, "about 1");
  EXPECT_EQ(compare(entry({{"about", true}}), rows)[0].deviation, "+50% (+1.7 of our errors)");
  EXPECT_EQ(compare(entry({{"about", 0.5}}), rows)[0].stated, "about 1");
  EXPECT_EQ(compare(entry({{"about", 0.5}}), rows)[0].deviation, "+50% (+1.7 of our errors)");
}

}  // namespace bagnold::analysis::test
