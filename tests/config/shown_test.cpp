// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/shown.hpp"

#include <gtest/gtest.h>

namespace bagnold {
namespace {

TEST(Shown, ShortTextIsAsItIs) { EXPECT_EQ(shown("a = \"\u03c6\""), "a = \"\u03c6\""); }

TEST(Shown, ControlCharactersAreSpelledOut) {
  EXPECT_EQ(shown("a\nb\x1b[31m\x7f"), "a\\u000ab\\u001b[31m\\u007f");
}

TEST(Shown, LongTextIsCutBetweenCharacters) {
  EXPECT_EQ(shown(std::string(1000, 'x')), std::string(200, 'x') + "...");
  std::string text = "x";
  for (int k = 0; k < 500; ++k) text += "\u03c6";
  auto const cut = shown(text);
  EXPECT_EQ(cut.size(), 199 + 3);
  EXPECT_EQ(cut.substr(0, 199), text.substr(0, 199));
}

}  // namespace
}  // namespace bagnold
