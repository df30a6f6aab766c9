// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/mistakes.hpp"

#include <gtest/gtest.h>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

std::size_t lines(std::string const& text) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Mistakes, OfAFileAreToldTogether) {
  auto text = with_line(minimal_text, "model", "model = \"CD_x\"");
  text = with_line(text, "count", "count = 7");
  text = with_line(text, "strain_rate", "strain_rate = -1");
  auto const said = refusal(text + "[measure]\nevery = 0\ncorrelations = true\n");
  for (auto const* word : {"disks.model", "disks.count = 7 (must be even", "shear.strain_rate = -1",
                           "measure.every = 0", "measure.correlations = true"})
    EXPECT_TRUE(has(said, word)) << said;
  EXPECT_EQ(lines(said), 5u) << said;
}

TEST(Mistakes, WhatFollowsFromAnotherIsNotTold) {
  EXPECT_EQ(lines(refusal(minimal_text + "protocol = \"rump\"\nramp_rate = 1e-3\n")), 1u);
  EXPECT_EQ(lines(refusal(with_line(minimal_text, "count", "cuont = 64"))), 1u);
  EXPECT_EQ(lines(refusal("disks = 5\n[shear]\nstrain = 1\nstrain_rate = 1\n")), 1u);
}

TEST(Mistakes, MissingKeysShareALine) {
  auto const said = refusal(with_line(with_line(minimal_text, "model", ""), "count", ""));
  EXPECT_TRUE(has(said, "disks.model is missing")) << said;
  EXPECT_TRUE(has(said, "disks.count is missing")) << said;
  EXPECT_EQ(lines(said), 1u) << said;
}

}  // namespace
}  // namespace bagnold
