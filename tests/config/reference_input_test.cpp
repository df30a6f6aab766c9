// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <tuple>

#include "kernels/physics/laws/laws.hpp"
#include "src/config/ladder.hpp"
#include "src/config/names.hpp"
#include "src/config/plan.hpp"
#include "src/config/scene_physics.hpp"
#include "src/sweep/sweep.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

std::filesystem::path const inputs = source_folder / "inputs";

std::string text_of(std::filesystem::path const& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ReferenceInput, OptionalKeysHaveTheirDefaults) {
  Scene const reference = read_scene(inputs / "reference.toml");
  Scene const defaults;
  for_each_key(reference, [&](Key const& key, auto const& value) {
    for_each_key(defaults, [&](Key const& other, auto const& initial) {
      if constexpr (std::is_same_v<decltype(value), decltype(initial)>)
        if (key.name == other.name && !key.required) {
          EXPECT_EQ(value, initial) << key.name;
        }
    });
  });
}

TEST(ReferenceInput, ShowsEveryKeyOnItsOwnLineInTheirOrder) {
  std::string const text = text_of(inputs / "reference.toml");
  std::size_t at = 0;
  std::string table;
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    auto const dot = key.name.find('.');
    if (dot != std::string_view::npos && key.name.substr(0, dot) != table) {
      table = key.name.substr(0, dot);
      at = text.find("\n[" + table + "]\n", at);
      ASSERT_NE(at, std::string::npos) << table;
    }
    std::string const line = std::string(key.name.substr(dot + 1)) + " = ";
    // start.file has no default: shown as a comment
    at = std::min(text.find("\n" + line, at), text.find("\n# " + line, at));
    ASSERT_NE(at, std::string::npos) << key.name << " is missing or out of order";
  });
}

TEST(ReferenceInput, RequiredKeysAloneResolveToTheSame) {
  Scene const reference = read_scene(inputs / "reference.toml");
  std::string text;
  std::string table;
  for_each_key(reference, [&](Key const& key, auto const& value) {
    if (!key.required) return;
    auto const dot = key.name.find('.');
    if (key.name.substr(0, dot) != table) {
      table = key.name.substr(0, dot);
      text += "[" + table + "]\n";
    }
    std::ostringstream line;
    line.precision(17);
    if constexpr (std::is_same_v<decltype(value), std::string const&>)
      line << key.name.substr(dot + 1) << " = \"" << value << "\"\n";
    else if constexpr (requires { line << value; })
      line << key.name.substr(dot + 1) << " = " << value << "\n";
    text += line.str();
  });
  Scene chooses = reference;
  ASSERT_TRUE(auto_is_default(reference));
  chooses.integration.scheme = automatic;
  EXPECT_TRUE(same(parse(text), chooses));
}

TEST(ReferenceInput, RequiredAreTheSevenKeysOfTheContract) {
  std::vector<std::string> required_keys;
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    if (key.required) required_keys.emplace_back(key.name);
  });
  EXPECT_EQ(required_keys,
            (std::vector<std::string>{"disks.model", "disks.count", "disks.packing_fraction",
                                      "disks.elasticity", "disks.mass", "shear.strain_rate",
                                      "shear.strain"}));
}

void check_feasible_here(Scene const& scene, Plan const& plan) {
  check_feasible(scene, plan, /*allow_unstable=*/false);
}

TEST(Inputs, AllParse) {
  int files = 0;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(inputs)) {
    if (entry.path().extension() != ".toml" || entry.path().filename() == "figures.toml") continue;
    if (sweep::is_sweep(text_of(entry.path()), "input"))
      EXPECT_NO_THROW(sweep::read_sweep(entry.path(), check_feasible_here)) << entry.path();
    else
      EXPECT_NO_THROW(read_scene(entry.path())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 2);
}

TEST(Keys, ModelWordsAreTheNamesOfTheLaws) {
  std::vector<std::string_view> const names = std::apply(
      [](auto... law) { return std::vector<std::string_view>{decltype(law)::name...}; }, Laws{});
  std::vector<std::string_view> words;
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    if (key.name == "disks.model") words = key.words;
  });
  EXPECT_EQ(words, names);
}

TEST(Keys, SceneRotatesWhereItsLawDoes) {
  std::apply(
      [](auto... law) {
        Scene scene;
        (
            [&] {
              scene.disks.model = decltype(law)::name;
              EXPECT_EQ(scene.rotates(), decltype(law)::rotates) << scene.disks.model;
            }(),
            ...);
      },
      Laws{});
}

}  // namespace
}  // namespace bagnold
