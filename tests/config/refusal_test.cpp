// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

TEST(Refusals, UnknownKeysGetTheNearestOne) {
  EXPECT_TRUE(has(refusal("titel = \"x\"\n" + minimal_text),
                  "scene.toml:1:9: unknown key titel; did you mean title?"))
      << refusal("titel = \"x\"\n" + minimal_text);
  EXPECT_TRUE(has(refusal(minimal_text + "[measure]\nevry = 3\n"),
                  "scene.toml:11:8: unknown key measure.evry; did you mean measure.every?"))
      << refusal(minimal_text + "[measure]\nevry = 3\n");
  EXPECT_TRUE(has(refusal(minimal_text + "strainrate = 1\n"), "did you mean shear.strain_rate?"));
  EXPECT_TRUE(has(refusal(minimal_text + "[mesure]\nevery = 3\n"),
                  "unknown table mesure; did you mean measure?"));
  EXPECT_TRUE(has(refusal(minimal_text + "[output.plot]\nx = 3\n"), "output.plot"));
  EXPECT_TRUE(has(refusal(minimal_text + "[output.plots]\nx = 3\n"), "unknown table output.plots"));
  EXPECT_TRUE(has(refusal(minimal_text + "\"out.put\" = 3\n"), "unknown key shear.out.put"));
  EXPECT_TRUE(has(refusal(minimal_text + "[disk]\n"), "unknown table disk; did you mean disks?"));
}

TEST(Refusals, EveryKeyMisspeltIsSuggested) {
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    std::string wrong(key.name);
    wrong.back() = 'q';  // no key ends so
    std::string const message = refusal(minimal_text, {wrong + "=1"});
    EXPECT_TRUE(has(message, "unknown key " + wrong)) << message;
    EXPECT_TRUE(has(message, "did you mean " + std::string(key.name) + "?")) << message;
  });
}

TEST(Refusals, MissingKeysAreNamed) {
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    if (!key.required) return;
    std::string const name(key.name.substr(key.name.find('.') + 1));
    std::string const message = refusal(with_line(minimal_text, name, ""));
    EXPECT_TRUE(has(message, std::string("scene.toml: ") + std::string(key.name) + " is missing"))
        << message;
  });
  EXPECT_TRUE(has(refusal(""), "disks.model is missing"));
}

TEST(Refusals, SayWhereWhichAndWhat) {
  struct Case {
    std::string key, line, place, value;
  };
  for (auto const& c : std::vector<Case>{
           {"model", "model = \"CD_x\"", ":2:9: disks.model", "\"CD_x\""},
           {"model", "model = 3", ":2:9: disks.model", "3"},
           {"model", "model = [\"CD\"]", ":2:9: disks.model", "an array"},
           {"elasticity", "elasticity = 1.0\nreplicas = 0", ":6:12: disks.replicas", "0"},
           {"elasticity", "elasticity = 1.0\nreplicas = -2", ":6:12: disks.replicas", "-2"},
           {"elasticity", "elasticity = 1.0\nreplicas = 4097", ":6:12: disks.replicas", "4097"},
           {"count", "  count = 0", ":3:11: disks.count", "0"},
           {"count", "count = 10.0", ":3:9: disks.count", "10.0"},
           {"count", "count = \"10\"", ":3:9: disks.count", "\"10\""},
           {"packing_fraction", "packing_fraction = -0.5", ":4:20: disks.packing_fraction", "-0.5"},
           {"packing_fraction", "packing_fraction = nan", ":4:20: disks.packing_fraction", "nan"},
           {"elasticity", "elasticity = inf", ":5:14: disks.elasticity", "inf"},
           {"elasticity", "elasticity = true", ":5:14: disks.elasticity", "true"},
           {"mass", "mass = \"heavy\"", ":6:8: disks.mass", "\"heavy\""},
           {"strain_rate", "strain_rate = 2", ":8:15: shear.strain_rate", "2"},
           {"strain", "strain = {a = 1}", ":9:10: shear.strain", "a table"},
           {"strain", "strain = 2020-02-02", ":9:10: shear.strain", "2020-02-02"}}) {
    std::string const message = refusal(with_line(minimal_text, c.key, c.line));
    EXPECT_TRUE(has(message, "scene.toml" + c.place + " = " + c.value + " (must be")) << message;
  }
  EXPECT_TRUE(has(refusal("disks = 5\n"), "scene.toml:1:9: disks = 5 (must be a table)"));
  EXPECT_TRUE(has(refusal(with_line(minimal_text, "mass", "mass = ")), "scene.toml:6:"));
  EXPECT_TRUE(has(refusal(with_line(minimal_text, "mass", "model = \"CD\"")), "scene.toml:6:"));
  EXPECT_TRUE(has(refusal(minimal_text + "[disks]\n"), "scene.toml:10:"));
  EXPECT_TRUE(has(refusal(with_line(minimal_text, "count", "count = 99999999999999999999")),
                  "scene.toml:3:"));
}

TEST(Refusals, AllowedWordsAreListed) {
  std::string const message = refusal(with_line(minimal_text, "model", "model = \"cd\""));
  for (auto const* word : {"\"CD\"", "\"CD_n\"", "\"CD_rot\"", "\"CD_nt\""})
    EXPECT_TRUE(has(message, word)) << message;
}

TEST(Refusals, Contradictions) {
  auto const with = [](std::string const& more) { return refusal(minimal_text, {more}); };
  EXPECT_TRUE(has(with("disks.count=1023"), "disks.count = 1023")) << with("disks.count=1023");
  EXPECT_TRUE(has(with("disks.count=1023"), "1022 or 1024"));
  EXPECT_TRUE(has(with("disks.packing_fraction=1"), "disks.packing_fraction = 1"));
  EXPECT_TRUE(has(with("disks.force_exponent=2.2"), "disks.force_exponent = 2.2"));
  EXPECT_TRUE(has(with("disks.damping_normal=2"), "disks.damping_normal"));
  EXPECT_TRUE(has(with("disks.damping_tangential=0"), "disks.damping_tangential"));
  EXPECT_TRUE(has(with("start.kind=state"), "start.file"));
  EXPECT_TRUE(has(with("start.file=a.h5"), "start.file"));
  EXPECT_TRUE(has(with("shear.discard=1"), "shear.discard = 1"));
  EXPECT_TRUE(has(refusal(minimal_text, {"disks.model=CD", "measure.rotation=true"}),
                  "measure.rotation = true"));
  EXPECT_EQ(refusal(minimal_text, {"disks.model=CD_nt", "disks.damping_tangential=0"}), "accepted");
}

TEST(Refusals, WhatImplicitDampingCannotDo) {
  auto const with = [](std::vector<std::string> more) {
    more.push_back("integration.scheme=implicit-damping");
    return refusal(minimal_text, more);
  };
  for (std::string const engine : {"few-contacts", "lookahead"})
    EXPECT_TRUE(has(with({"integration.engine=" + engine}),
                    "integration.engine = \"" + engine + "\" (steps the disks that touch alone"));
  for (std::string const engine : {"auto", "reference", "many-contacts"})
    EXPECT_EQ(with({"integration.engine=" + engine}), "accepted");
  EXPECT_TRUE(has(with({"drive.kind=stokes", "drive.drag=0.1"}),
                  "drive.kind = \"stokes\" (is not a part of what"));
}

TEST(Refusals, ContradictionsOfDrives) {
  auto const with = [](std::vector<std::string> const& more) {
    return refusal(minimal_text, more);
  };
  EXPECT_TRUE(has(with({"drive.drag=0.1"}), "set drive.kind = \"stokes\" or \"thermal\""))
      << with({"drive.drag=0.1"});
  EXPECT_TRUE(has(with({"drive.kind=stokes"}), "drive.drag = 0 (drive.kind"));
  EXPECT_TRUE(has(with({"drive.kind=thermal", "drive.drag=0.1"}), "drive.temperature = 0 (drive"));
  EXPECT_TRUE(has(with({"drive.kind=stokes", "drive.drag=0.1", "drive.temperature=1e-3"}),
                  "set drive.kind = \"thermal\""));
  EXPECT_TRUE(has(with({"drive.kind=wind"}), "must be one of \"none\", \"stokes\", \"thermal\""));
  for (std::string const engine : {"few-contacts", "lookahead"}) {
    auto const message =
        with({"drive.kind=stokes", "drive.drag=0.1", "integration.engine=" + engine});
    EXPECT_TRUE(has(message, "integration.engine = \"" + engine + "\" (needs disks that fly"))
        << message;
    EXPECT_EQ(with({"integration.engine=" + engine}), "accepted");
  }
  for (std::string const engine : {"auto", "reference", "many-contacts"})
    EXPECT_EQ(with({"drive.kind=thermal", "drive.drag=0.1", "drive.temperature=1e-3",
                    "integration.engine=" + engine}),
              "accepted");
}

/// A scene whose numeric key `wanted` has the value `value`, as text.
std::string scene_with(Key const& wanted, double value) {
  Scene scene = parse(text_for(wanted));
  scene.disks.model = "CD_nt";  // the one that takes every key
  if (wanted.name.starts_with("drive.")) scene.drive = {"thermal", 0.1, 1e-3};
  for_each_key(scene, [&](Key const& key, auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if (key.name != wanted.name) return;
    if constexpr (std::is_same_v<Member, std::int64_t>)
      member = static_cast<std::int64_t>(value);
    else if constexpr (std::is_same_v<Member, double> || std::is_same_v<Member, NumberOrList> ||
                       std::is_same_v<Member, std::optional<double>> ||
                       std::is_same_v<Member, NumberOrWord>)
      member = value;
  });
  return write_scene(scene);
}

TEST(Ranges, EndWhereTheKeysSay) {
  Scene scene;
  int edges = 0;
  for_each_key(scene, [&](Key const& key, auto const& member) {
    using Member = std::decay_t<decltype(member)>;
    constexpr bool whole = std::is_same_v<Member, std::int64_t>;
    if constexpr (whole || std::is_same_v<Member, double> || std::is_same_v<Member, NumberOrList> ||
                  std::is_same_v<Member, std::optional<double>> ||
                  std::is_same_v<Member, NumberOrWord>) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      auto const expect_refused = [&](double value) {
        std::string const message = refusal(scene_with(key, value));
        EXPECT_TRUE(has(message, std::string(key.name) + " = ")) << key.name << " " << message;
        EXPECT_TRUE(has(message, key.open_below ? "(must be above" : "(must be at least") ||
                    has(message, "(must be finite"))
            << message;
        ++edges;
      };
      auto const expect_in_range = [&](double value) {
        std::string const message = refusal(scene_with(key, value));
        EXPECT_FALSE(has(message, "(must be above ") || has(message, "(must be at least "))
            << message;
      };
      double const least = key.least, most = key.most;
      ASSERT_TRUE(std::isfinite(least)) << key.name << " has no lower bound";
      expect_refused(whole ? least - 1 : std::nextafter(least, -infinity));
      if (key.open_below) {
        expect_refused(least);
        expect_in_range(std::nextafter(least, infinity));
      } else {
        expect_in_range(least);
      }
      if (std::isfinite(most)) {
        // one more than 9.2e18 is lost in a double; the next double is not
        expect_refused(whole && most < 9e15 ? most + 1 : std::nextafter(most, infinity));
        expect_in_range(most);
      }
      if (!whole) {
        for (auto const* strange : {"nan", "inf", "-inf", "+nan"})
          EXPECT_TRUE(has(refusal(text_for(key), {std::string(key.name) + "=" + strange}),
                          "(must be finite"))
              << key.name << " = " << strange;
      }
    }
  });
  EXPECT_GE(edges, 3 * 12);
}

TEST(Types, AWholeNumberIsANumber) {
  Scene const scene = parse(minimal_text, {"disks.elasticity=3", "integration.time_step=1",
                                           "output.checkpoint_minutes=+7"});
  EXPECT_EQ(scene.disks.elasticity, 3.0);
  EXPECT_EQ(scene.integration.time_step, 1.0);
  EXPECT_EQ(scene.output.checkpoint_minutes, 7.0);
}

TEST(Types, OtherwiseTheyAreWhatTheyAre) {
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const& member) {
    using Member = std::decay_t<decltype(member)>;
    std::string const set = std::string(key.name) + "=";
    std::vector<std::string> wrong{"12:30:00", "[]"};
    if (!std::is_same_v<Member, std::vector<double>> && key.name != "shear.stress")
      wrong.push_back("[1]");
    if (!std::is_same_v<Member, std::map<std::string, double>>) wrong.push_back("{a = 1}");
    if (!std::is_same_v<Member, bool>) wrong.push_back("true");
    if (!std::is_same_v<Member, std::string>) wrong.insert(wrong.end(), {"\"1\"", "\"\"", "word"});
    if (std::is_same_v<Member, std::int64_t>) wrong.insert(wrong.end(), {"64.0", "1e3"});
    if (std::is_same_v<Member, std::string> || std::is_same_v<Member, bool>)
      wrong.insert(wrong.end(), {"1", "0.5"});
    for (auto const& value : wrong) {
      std::string const message = refusal(text_for(key), {set + value});
      EXPECT_TRUE(has(message, std::string(key.name) + " = ") && has(message, "(must be "))
          << set + value << ": " << message;
    }
  });
}

TEST(Types, ATimeStepHasTwoWords) {
  for (auto const* word : {"auto", "paper"}) {
    std::string const set = std::string("integration.time_step=") + word;
    EXPECT_EQ(parse(minimal_text, {set}).integration.time_step, NumberOrWord(word));
  }
  for (auto const* word : {"Auto", "papers", "modified-velocity-verlet", "\"\""})
    EXPECT_TRUE(has(refusal(minimal_text, {std::string("integration.time_step=") + word}),
                    "(must be a number or one of \"auto\", \"paper\")"))
        << word;
}

TEST(Text, StrangeBytesAreRefusedAtTheirPlace) {
  auto const at = [](std::string const& text) {
    std::string const message = refusal(text + minimal_text);
    return message.substr(0, message.find(": byte"));
  };
  EXPECT_EQ(at("\xef\xbb\xbf"), "scene.toml:1:1");
  EXPECT_EQ(at("# a\n \x01"), "scene.toml:2:2");
  EXPECT_EQ(at(std::string("a\0b", 3)), "scene.toml:1:2");
  EXPECT_EQ(at("title = \xe2\x80\x9cx\xe2\x80\x9d\n"), "scene.toml:1:9");  // typographic quotes
  EXPECT_EQ(at("\n\ntitle\x7f = 1"), "scene.toml:3:6");
  EXPECT_EQ(at("title = \"a\x1b[31m\"\n"), "scene.toml:1:11");
  EXPECT_EQ(at("# comment \x02\n"), "scene.toml:1:11");
  EXPECT_EQ(at("title = 'a' \xa0\n"), "scene.toml:1:13");
  EXPECT_EQ(at("title = \"a\\\"b\" \xa0\n"), "scene.toml:1:16");
  EXPECT_EQ(at("title = \"\"\"x\"\"\" \xa0\n"), "scene.toml:1:17");
  EXPECT_EQ(at("title = \"\"\"x\\\n  y\"\"\"\n\xa0\n"), "scene.toml:3:1");
}

TEST(Text, OtherAlphabetsBelongInCommentsAndStrings) {
  EXPECT_EQ(
      parse("# \u03c6 and \u03b3\u0307\ntitle = \"\u03c6\" # Gr\u00fc\u00dfe\n" + minimal_text)
          .title,
      "\u03c6");
  EXPECT_EQ(parse("title = '''a\u00e9'b\n# \u00e9'''\n" + minimal_text).title,
            "a\u00e9'b\n# \u00e9");
  EXPECT_EQ(parse("title = \"\\\\\" # \u00e9\n" + minimal_text).title, "\\");
}

TEST(Text, LinesMayEndAsOnWindows) {
  std::string text = minimal_text;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, "\r");
  EXPECT_TRUE(same(parse(text), parse(minimal_text)));
}

TEST(Text, InvalidUtf8IsRefused) {
  EXPECT_NE(refusal("title = \"\xff\xfe\"\n" + minimal_text), "accepted");
  EXPECT_NE(refusal("title = \"\xc3\"\n" + minimal_text), "accepted");
  EXPECT_NE(refusal("# \xff\n" + minimal_text), "accepted");
}

TEST(Text, DeepNestingIsRefused) {
  auto const repeated = [](std::string const& part, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) text += part;
    return text;
  };
  EXPECT_TRUE(has(refusal("title = " + std::string(10000, '[')), "scene.toml:1:"));
  EXPECT_TRUE(has(refusal(std::string(10000, '[')), "scene.toml:1:"));
  EXPECT_TRUE(has(refusal("title = " + repeated("{a=", 10000)), "scene.toml:1:"));
  EXPECT_TRUE(has(refusal(repeated("a.", 400000) + "a = 1\n"), "scene.toml:1:"));
  EXPECT_TRUE(has(refusal("[" + repeated("a.", 400000) + "a]\n"), "scene.toml:1:"));
  EXPECT_TRUE(has(refusal(minimal_text, {"title=" + std::string(10000, '[')}), "--set"));
}

TEST(Text, LongTextIsRefusedOrRead) {
  EXPECT_EQ(parse("title = \"" + std::string(900000, 'x') + "\"\n" + minimal_text).title.size(),
            900000u);
  EXPECT_TRUE(has(refusal(std::string(20000, 'k') + " = 1\n"), "unknown key"));
}

class SceneFile : public testing::Test {
 protected:
  SceneFile() { std::filesystem::create_directories(folder_); }
  ~SceneFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(std::string const& text) const {
    std::ofstream(folder_ / "a scene.toml", std::ios::binary) << text;
    return folder_ / "a scene.toml";
  }

  static std::string refusal_of(std::filesystem::path const& file) {
    try {
      read_scene(file);
    } catch (InputError const& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path const folder_ =
      std::filesystem::temp_directory_path() / ("bagnold-scene-" + std::to_string(getpid()));
};

TEST_F(SceneFile, IsNamedInMessages) {
  auto const file = write(with_line(minimal_text, "count", "count = 0"));
  EXPECT_TRUE(has(refusal_of(file), file.string() + ":3:9: disks.count = 0")) << refusal_of(file);
}

TEST_F(SceneFile, MissingFolderAndHugeFilesAreRefused) {
  EXPECT_TRUE(has(refusal_of(folder_ / "none.toml"), "none.toml: cannot be read"));
  EXPECT_TRUE(has(refusal_of(folder_), "is a folder"));
  EXPECT_TRUE(has(refusal_of(write(minimal_text + std::string(1 << 20, '\n'))), "over 1 MiB"));
  EXPECT_EQ(refusal_of(write(minimal_text + std::string(1 << 19, '\n'))), "accepted");
}

TEST_F(SceneFile, StateFileIsBesideIt) {
  auto const file = write(minimal_text + "[start]\nkind = \"state\"\nfile = \"s.h5\"\n");
  EXPECT_EQ(read_scene(file).start.file, (folder_ / "s.h5").string());
}

}  // namespace
}  // namespace bagnold
