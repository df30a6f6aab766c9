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

TEST(NearestWord, FewestEditsWin) {
  EXPECT_EQ(nearest_word("kitten", {"mitten", "kitteny"}), "mitten");  // of equals the same length
  EXPECT_EQ(nearest_word("kitten", {"kittxxn", "kittxn"}), "kittxn");
  EXPECT_EQ(nearest_word("kitten", {"kittenxx", "sitten"}), "sitten");
}

TEST(NearestWord, SwapsCountOnce) {
  EXPECT_EQ(nearest_word("sikn", {"skin"}), "skin");
  EXPECT_EQ(nearest_word("--otu", {"--out", "--all"}), "--out");
}

/// Two words of as many letters that share some are not alike.
TEST(NearestWord, WhatIsFarIsNone) {
  EXPECT_EQ(nearest_word("friction", {"replicas", "rotation", "packing_fraction"}), "");
  EXPECT_EQ(nearest_word("dt", {"skin", "drag", "p"}), "");
  EXPECT_EQ(nearest_word("list", {"plot", "status", "validate"}), "");
  EXPECT_EQ(nearest_word("pressure", {"rescale", "measure"}), "");
  EXPECT_EQ(nearest_word("N", {"Z", "p", "kind"}), "");
  EXPECT_EQ(nearest_word("kitten", {"sittens"}), "sittens");  // 2 of 7 letters
  EXPECT_EQ(nearest_word("kitten", {"sitting"}), "");
}

TEST(NearestWord, PartsAreNear) {
  EXPECT_EQ(nearest_word("--output", {"--out", "--all"}), "--out");
  EXPECT_EQ(nearest_word("rate", {"strain", "strain_rate"}), "strain_rate");
  EXPECT_EQ(nearest_word("sigma", {"p", "sigma_el"}), "sigma_el");
  EXPECT_EQ(nearest_word("ate", {"strain_rate"}), "") << "no word of it";
}

TEST(NearestWord, IsAskedFor) {
  EXPECT_EQ(did_you_mean("rum", {"run"}), "; did you mean run?");
  EXPECT_EQ(did_you_mean("hello", {"run"}), "");
  EXPECT_EQ(did_you_mean("hello", {"run"}, "."), ".");
}

TEST(NearestWord, LettersCountBeforeCaseAndPunctuation) {
  EXPECT_EQ(nearest_word("Bp", {"p", "Z", "B_p", "B_p_el"}), "B_p");
  EXPECT_EQ(nearest_word("check_limit", {"check-limit", "checks"}), "check-limit");
  EXPECT_EQ(nearest_word("cd_N", {"CD", "CD_n", "CD_rot"}), "CD_n");
}

TEST(NearestWord, TheRestOfALongWordIsLeftOut) {
  EXPECT_EQ(nearest_word(std::string(100'000'000, 'x'), {std::string(100, 'x'), "y"}),
            std::string(100, 'x'));
}

TEST(NearestWord, Edges) {
  EXPECT_EQ(nearest_word("", {"four", "six"}), "");
  EXPECT_EQ(nearest_word("...", {"four", "six"}), "");
  EXPECT_EQ(nearest_word("x", {""}), "");
  EXPECT_EQ(nearest_word("x", {}), "");
  EXPECT_EQ(nearest_word("abc", {"abd", "abe"}), "abd");  // the first of equals
}

}  // namespace
}  // namespace bagnold
