// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

Scene with(std::string const& override_text) { return parse(minimal_text, {override_text}); }

TEST(Overrides, TakeNumbersWordsAndQuotedText) {
  EXPECT_EQ(with("disks.packing_fraction=0.80").disks.packing_fraction, 0.80);
  EXPECT_EQ(with("shear.strain=7").shear.strain, 7.0);
  EXPECT_EQ(with("disks.count=1_000").disks.count, 1000);
  EXPECT_EQ(with("disks.model=CD").disks.model, "CD");
  EXPECT_EQ(with("disks.model=\"CD\"").disks.model, "CD");
  EXPECT_EQ(with("disks.model='CD'").disks.model, "CD");
  EXPECT_EQ(with("output.plot=false").output.plot, false);
  EXPECT_EQ(with("title=two words").title, "two words");
  EXPECT_EQ(with("title=\"5\"").title, "5");
  EXPECT_EQ(with("title=\"a\\nb\"").title, "a\nb");
  EXPECT_EQ(with("title=\u03c6").title, "\u03c6");
  EXPECT_EQ(with("title=\"a=b # c\"").title, "a=b # c");
}

TEST(Overrides, ApplyInOrderAndToAbsentTables) {
  EXPECT_EQ(parse(minimal_text, {"disks.count=10", "disks.count=12"}).disks.count, 12);
  EXPECT_EQ(with("measure.every=3").measure.every, 3);
  EXPECT_EQ(parse("", {"disks.model=CD", "disks.count=10", "disks.packing_fraction=0.5",
                       "disks.elasticity=2", "disks.mass=area", "shear.strain_rate=1e-3",
                       "shear.strain=1"})
                .disks.mass,
            "area");
}

TEST(Overrides, RepairWhatTheFileHasWrong) {
  std::string const text = with_line(minimal_text, "count", "count = -4");
  EXPECT_EQ(parse(text, {"disks.count=4"}).disks.count, 4);
}

TEST(Overrides, AreCheckedLikeTheFile) {
  for (auto const* bad : {"disks.count=7",
                          "disks.count=10.0",
                          "disks.count=[10]",
                          "disks.model=[\"CD\"]",
                          "disks.model={a = 1}",
                          "disks.model=",
                          "disks.model",
                          "=CD",
                          "disks=5",
                          "disks.count.x=1",
                          "disks..count=1",
                          ".count=1",
                          "disks.=1",
                          "count=10",
                          "disks.kount=10",
                          "dusks.count=10",
                          "disks.packing_fraction=nan",
                          "disks.model=\"CD",
                          "disks.model=CD\"",
                          "disks .count=10",
                          "di[sks.count=10",
                          "title=true",
                          "shear.strain=1e999"}) {
    std::string const message = refusal(minimal_text, {bad});
    EXPECT_NE(message, "accepted") << bad;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(Overrides, MessagesNameThem) {
  std::string const message = refusal(minimal_text, {"disks.count=-2"});
  EXPECT_TRUE(has(message, "--set disks.count=-2")) << message;
  EXPECT_TRUE(has(message, "disks.count = -2 (must be")) << message;
}

TEST(Overrides, OfAnUnknownTableAreNamedToo) {
  auto const message = refusal(minimal_text, {"foo.bar=1"});
  EXPECT_TRUE(has(message, "--set foo.bar=1")) << message;
  EXPECT_FALSE(has(message, ":0:0")) << message;
  auto const seed = refusal(minimal_text, {"run.seed=1"});
  EXPECT_TRUE(has(seed, "unknown key run.seed; did you mean disks.seed?")) << seed;
}

TEST(Overrides, CannotBringMoreThanOneValue) {
  for (auto const* bad : {"disks.count=10\n[shear]\nstrain = 3", "disks.count=10\nmass = \"area\"",
                          "measure.every=1\n[x]", "title=x\n[y]", "title=\"x\"\n[y]",
                          "measure.every=1\nvalue = 2", "measure.every=1\n[value]", "a.b=1\n[x]",
                          "measure\n.every=1", "title=\"a\"\nb", "measure.every=1,2", "title=a\nb"})
    EXPECT_NE(refusal(minimal_text, {bad}), "accepted") << bad;
}

/// A scene is written into the run's folder: what was accepted must be readable again.
TEST(Overrides, WhatIsAcceptedReadsBack) {
  for (std::string const& value :
       std::vector<std::string>{"\xff", "a\xc3", "a\x01z", "a\x7f", "\xed\xa0\x80",
                                "\xf5\x80\x80\x80", "\\", "a\tb", "a\rb", "\u00e9"}) {
    Scene scene;
    try {
      scene = with("title=" + value);
    } catch (InputError const&) {
      continue;  // refused is fine
    }
    std::string title = "unreadable";
    try {
      title = parse(write_scene(scene)).title;
    } catch (InputError const& error) {
      title += std::string(": ") + error.what();
    }
    EXPECT_EQ(title, scene.title) << testing::PrintToString(value);
  }
}

}  // namespace
}  // namespace bagnold
