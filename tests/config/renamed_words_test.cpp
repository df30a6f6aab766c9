// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/config/names.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

Scene read(std::vector<std::string> const& overrides, std::vector<std::string>& notes) {
  return parse_scene(minimal_text, "scene.toml", {}, overrides, &notes);
}

TEST(RenamedWords, AreReadAsWhatTheyAreCalledNowAndTold) {
  std::pair<char const*, char const*> const engines[] = {
      {"dense", "few-contacts"}, {"contact-rich", "many-contacts"}, {"windowed", "lookahead"}};
  for (auto const& [before, now] : engines) {
    std::vector<std::string> notes;
    auto const scene = read({std::string("integration.engine=") + before}, notes);
    EXPECT_EQ(scene.integration.engine, now);
    ASSERT_EQ(notes.size(), 1u) << before;
    for (auto const* word : {before, now, "integration.engine", "--set"})
      EXPECT_NE(notes[0].find(word), std::string::npos) << word << " in " << notes[0];
  }
  std::vector<std::string> notes;
  EXPECT_EQ(read({"disks.model=general", "disks.damping_tangential=0.5"}, notes).disks.model,
            "CD_nt");
  EXPECT_EQ(notes.size(), 1u);
}

TEST(RenamedWords, OfTodayAreNotTold) {
  std::vector<std::string> notes;
  EXPECT_EQ(read({"integration.engine=lookahead", "disks.model=CD_nt"}, notes).disks.model,
            "CD_nt");
  EXPECT_TRUE(notes.empty());
}

/// A word of another key is not taken for it.
TEST(RenamedWords, BelongToTheirKeys) {
  std::vector<std::string> notes;
  EXPECT_THROW(read({"disks.model=dense"}, notes), InputError);
  EXPECT_THROW(read({"integration.engine=general"}, notes), InputError);
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace bagnold
