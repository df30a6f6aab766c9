// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/abilities.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

/// A demand of a scene: the key, how a scene asks for it, and its heading in docs/engines.md.
struct Asked {
  std::string heading;
  WhyNot Abilities::*why_not;
  std::vector<std::string> overrides;
  bool of_ramp = false;
};

std::vector<Asked> const all_asked = {
    {"implicit damping", &Abilities::implicit_schemes, {"integration.scheme=implicit-damping"}},
    {"papers' step", &Abilities::paper_time_step, {"integration.time_step=paper"}},
    {"overdamped", &Abilities::overdamped_contacts, {"disks.elasticity=0.5"}},
    {"Hertz", &Abilities::other_repulsions, {"disks.force_exponent=2.5"}},
    {"drives", &Abilities::drives, {"drive.kind=stokes", "drive.drag=0.1"}},
    {"ramps", &Abilities::ramps, {}, true},
    {"contacts", &Abilities::contacts, {"measure.contacts=true"}},
    {"profiles", &Abilities::profiles, {"measure.profiles=true"}}};

bool can(Abilities const& engine, Asked const& asked) {
  bool const of_own_scheme = asked.heading == "implicit damping" && !engine.scheme.empty();
  return (engine.*asked.why_not).empty() && !of_own_scheme;
}

TEST(Abilities, DecideForEveryEngineAndDemand) {
  for (auto const& engine : all_engines())
    for (auto const& asked : all_asked) {
      auto overrides = asked.overrides;
      overrides.push_back(fmt::format("integration.engine={}", engine.engine));
      if (!asked.of_ramp) overrides.push_back("shear.strain_rate=1e-6");
      auto const message = refusal(asked.of_ramp ? ramp_text : minimal_text, overrides);
      SCOPED_TRACE(fmt::format("{}, {}: {}", engine.engine, asked.heading, message));
      if (can(engine, asked))
        EXPECT_EQ(message, "accepted");
      else
        EXPECT_NE(message.find(fmt::format("integration.engine = \"{}\" (", engine.engine)),
                  std::string::npos);
    }
}

TEST(Abilities, AreRefusedOnce) {
  for (auto const& engine : all_engines()) {
    Scene scene = minimal_scene();
    scene.integration.engine = engine.engine;
    scene.integration.scheme = automatic;
    scene.drive = {"stokes", 0.1, 0};
    EXPECT_EQ(why_not(scene).size(), engine.drives.empty() ? 0u : 1u) << engine.engine;
  }
}

/// The table of docs/engines.md.
TEST(Abilities, StandInTheDocs) {
  std::string table = "| `engine` |", line = "| --- |";
  for (auto const& asked : all_asked) table += " " + asked.heading + " |", line += " --- |";
  table += "\n" + line + "\n";
  for (auto const& engine : all_engines()) {
    table += fmt::format("| `\"{}\"` |", engine.engine);
    for (auto const& asked : all_asked) table += can(engine, asked) ? " ✓ |" : " – |";
    table += "\n";
  }
  std::ifstream file(BAGNOLD_SOURCE_FOLDER "/docs/engines.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find(table), std::string::npos) << "docs/engines.md lacks\n" << table;
}

}  // namespace
}  // namespace bagnold
