// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/config/scene_file.hpp"
#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

struct Bad {
  std::string table;
  std::vector<std::string> words;  ///< all of them are in the message
};

TEST(SweepRefusal, NamesKeyValueReasonAndRemedy) {
  for (auto const& [table, words] : std::vector<Bad>{
           {"", {"[sweep]", "bagnold run"}},
           {"[sweep]\n", {"varies nothing", "grid"}},
           {"[sweep]\ngird = {}", {":11:", "sweep.gird", "grid"}},
           {"[sweep]\ngrid = 3", {"sweep.grid = 3", "table of lists"}},
           {"[sweep]\ngrid = { \"disks.seed\" = 3 }", {"disks.seed = 3", "[3]"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [] }", {"disks.seed = []", "must have a value"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [{ a = 1 }] }",
            {"disks.seed", "a table is no value"}},
           {"[sweep]\nzip = { \"disks.seed\" = [1, 2], \"disks.elasticity\" = [1] }",
            {"disks.elasticity has 1", "disks.seed has 2", "grid"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [1] }\nzip = { \"disks.seed\" = [2] }",
            {":11:", "disks.seed is varied twice"}},
           {"[sweep]\nchain = \"shear.strain\"\ngrid = { \"disks.seed\" = [1] }",
            {"sweep.chain = \"shear.strain\"", "varies"}},
           {"[sweep]\nchain = \"disks.s\ted\"\ngrid = { \"disks.seed\" = [1] }",
            {"sweep.chain = \"disks.s\\u0009ed\"", "varies"}},
           {"[sweep]\ngrid = { \"disks.s\ted\" = [1] }", {"disks.s\\u0009ed is no key"}},
           {"[sweep]\nchain = 3\ngrid = { \"disks.seed\" = [1] }", {"sweep.chain = 3"}},
           {"[sweep]\ngrid = { \"disks.elastisity\" = [1] }",
            {"disks.elastisity", "did you mean disks.elasticity"}},
           {"[sweep]\ngrid = { \"sweep.grid\" = [1] }", {"sweep"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [1], \"disks.elasticity\" = [1, -1] }",
            {"point 2 of 2", "disks.seed = 1", ":11:", "disks.elasticity = -1", "at least"}},
           {"[sweep]\ngrid = { \"disks.count\" = [64, 65] }", {"point 2 of 2", "65", "even"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [1, \"x\"] }",
            {"point 2", "disks.seed = \"x\"", "integer"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [9007199254740993] }", {"disks.seed", "2^53"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [1, 2, 1] }", {"point 3", "same scene as point 1"}},
           {"[sweep]\ngrid = { \"disks.seed\" = [9, 5, 7], \"disks.replicas\" = [4] }",
            {"point 3", "disks.seed = 7", "shares systems with point 1", "seeds at least 4 apart"}},
           {"[sweep]\ngrid = { \"shear.strain\" = [1, 1e9] }\n[output]\nsample_strain = 1e-3",
            {"point 2", "sample_strain"}},
           {"[sweep]\nchain = \"disks.packing_fraction\"\n"
            "grid = { \"disks.packing_fraction\" = [0.8, 0.81] }",
            {"point 2", "sweep.chain", "disks.packing_fraction"}},
           {"[sweep]\nchain = \"disks.count\"\ngrid = { \"disks.count\" = [64, 128] }",
            {"point 2", "sweep.chain", "disks.count", "start.copies = [false, true]"}},
           {"[sweep]\nchain = \"disks.replicas\"\ngrid = { \"disks.replicas\" = [1, 2] }",
            {"point 2", "sweep.chain", "disks.replicas"}},
           {"[sweep]\nchain = \"disks.box_aspect\"\ngrid = { \"disks.box_aspect\" = [1, 2] }",
            {"point 2", "sweep.chain", "disks.box_aspect"}},
           {"[sweep]\nchain = \"shear.strain_rate\"\n"
            "zip = { \"start.kind\" = [\"state\", \"state\"], \"start.file\" = [\"a\", \"b\"], "
            "\"shear.strain_rate\" = [1e-3, 1e-4] }",
            {"point 2", "start.file = 'b'", "or put it in grid"}},
           {"[sweep]\nchain = \"disks.count\"\n"
            "zip = { \"disks.count\" = [64, 96], \"start.copies\" = [false, true] }",
            {"point 2", "the point before holds 64 disks", "disks.count = 96"}}}) {
    auto const message = refusal(table);
    for (auto const& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << table << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

/// Seeds of replicas that touch no others, also of chains, whose points share them.
TEST(SweepRefusal, NotOfReplicasOfTheirOwn) {
  EXPECT_EQ(refusal("[sweep]\nchain = \"shear.strain_rate\"\n"
                    "grid = { \"disks.seed\" = [5, 1, 9], \"shear.strain_rate\" = [1e-3, 1e-4], "
                    "\"disks.replicas\" = [4] }"),
            "accepted");
  EXPECT_EQ(refusal("[sweep]\nzip = { \"disks.seed\" = [1, 2], \"disks.elasticity\" = [1, 2], "
                    "\"disks.replicas\" = [4, 4] }"),
            "accepted");
}

TEST(SweepRefusal, OfCascades) {
  std::string cascade = base;
  auto const at = cascade.find("strain_rate = 1e-3");
  cascade.replace(at, 18, "protocol = \"cascade\"\nstrain_rates = [1e-2, 1e-3]");
  auto const refused = [&](std::string const& table) { return refusal(table, cascade); };
  EXPECT_EQ(refused("[sweep]\ngrid = { \"disks.seed\" = [1, 2] }"), "accepted");
  EXPECT_NE(refused("[sweep]\nchain = \"disks.seed\"\ngrid = { \"disks.seed\" = [1, 2] }")
                .find("sweep.chain does not go with shear.protocol = \"cascade\""),
            std::string::npos);
  EXPECT_NE(refused("[sweep]\ngrid = { \"shear.strain_rate\" = [1e-2] }").find("belongs to"),
            std::string::npos);
}

TEST(SweepRefusal, TooManyPoints) {
  std::string list = "0";
  for (int k = 1; k < 400; ++k) list += ", " + std::to_string(k);
  auto const message = refusal("[sweep]\ngrid = { \"disks.seed\" = [" + list +
                               "], \"disks.elasticity\" = [" + list + "] }");
  EXPECT_NE(message.find("160000 points"), std::string::npos) << message;
}

TEST(SweepRefusal, ASceneReaderPointsToTheSweepCommand) {
  try {
    parse_scene(base + "[sweep]\ngrid = { \"disks.seed\" = [1] }", "s.toml", "/");
    FAIL() << "accepted";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("bagnold sweep s.toml"), std::string::npos);
  }
}

TEST(SweepRefusal, WhatThePointsAreAskedIsToldWithThePoint) {
  io::TestFolder folder;
  std::ofstream(folder / "s.toml") << base << "[sweep]\ngrid = { \"disks.seed\" = [1, 2] }";
  auto const check = [](Scene const& scene, Plan const& plan) {
    EXPECT_GT(plan.steps, 0);
    if (scene.disks.seed == 2) throw InputError("not this one");
  };
  try {
    read_sweep(folder / "s.toml", check);
    FAIL() << "accepted";
  } catch (InputError const& error) {
    EXPECT_STREQ(error.what(), "point 2 of 2 (disks.seed = 2): not this one");
  }
}

}  // namespace
}  // namespace bagnold::sweep
