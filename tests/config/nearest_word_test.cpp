// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/nearest_word.hpp"

#include <gtest/gtest.h>

namespace bagnold {
namespace {

TEST(NearestWord, CountsInsertionsDeletionsAndSubstitutions) {
  std::vector<std::string> const words{"strain", "strain_rate", "discard", "skin"};
  EXPECT_EQ(nearest_word("strain", words), "strain");
  EXPECT_EQ(nearest_word("train", words), "strain");
  EXPECT_EQ(nearest_word("strains", words), "strain");
  EXPECT_EQ(nearest_word("strainrate", words), "strain_rate");
  EXPECT_EQ(nearest_word("diskard", words), "discard");
  EXPECT_EQ(nearest_word("sikn", words), "skin");
}

/// "kitten" takes 3 edits to "sitting"; a candidate at 2 and one at 4 stand beside it.
TEST(NearestWord, FewestEditsWin) {
  EXPECT_EQ(nearest_word("kitten", {"sitting", "kittenxxxx"}), "sitting");
  EXPECT_EQ(nearest_word("kitten", {"sitting", "mitt"}), "sitting");
  EXPECT_EQ(nearest_word("kitten", {"sitting", "kittenxx"}), "kittenxx");
}

TEST(NearestWord, LettersCountBeforeCaseAndPunctuation) {
  EXPECT_EQ(nearest_word("Bp", {"p", "Z", "B_p", "B_p_el"}), "B_p");
  EXPECT_EQ(nearest_word("check_limit", {"check-limit", "checks"}), "check-limit");
  EXPECT_EQ(nearest_word("cd_N", {"CD", "CD_n", "CD_rot"}), "CD_n");
}

TEST(NearestWord, TheRestOfALongWordIsLeftOut) {
  EXPECT_EQ(nearest_word(std::string(100'000'000, 'x'), {"x", "y"}), "x");
}

TEST(NearestWord, AnythingHasOne) {
  EXPECT_EQ(nearest_word("", {"four", "six"}), "six");
  EXPECT_EQ(nearest_word("x", {""}), "");
  EXPECT_EQ(nearest_word("abc", {"abd", "abe"}), "abd");  // the first of equals
}

}  // namespace
}  // namespace bagnold
