// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/config/scenes.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold {
namespace {

Scene round_trip(Scene const& scene) { return parse(write_scene(scene)); }

TEST(RoundTrip, KeepsEveryBitOfAwkwardNumbers) {
  Scene scene = minimal_scene();
  scene.disks.model = "CD_nt";
  for (double const value :
       {0.1 + 0.2, 1.0 / 3, 1e-300, 5e-324, std::nextafter(1.0, 0.0), std::nextafter(0.1, 1.0),
        2.2250738585072014e-308, 123456.0 / 1000001, 1.0 - 1.0 / 3}) {
    scene.disks.packing_fraction = value;
    scene.shear.strain_rate = value;
    scene.shear.strain = value * 1e5;
    scene.shear.discard = value;
    scene.disks.damping_normal = value;
    scene.integration.time_step = value;
    scene.output.sample_strain = value;
    scene.output.checkpoint_minutes = std::ldexp(value, 1000);
    EXPECT_TRUE(same(round_trip(scene), scene)) << write_scene(scene);
  }
}

TEST(RoundTrip, KeepsTheWordsOfTheIntegration) {
  Scene scene = minimal_scene();
  for (auto const scheme : {std::string_view(automatic), papers_scheme, two_stage_scheme})
    for (NumberOrWord const& step :
         {NumberOrWord(automatic), NumberOrWord(of_papers), NumberOrWord(0.25)}) {
      scene.integration.scheme = scheme;
      scene.integration.time_step = step;
      Scene const back = round_trip(scene);
      EXPECT_TRUE(same(back, scene)) << write_scene(scene);
      EXPECT_EQ(back.integration.scheme, scheme);
      EXPECT_EQ(back.integration.time_step, step);
    }
}

TEST(RoundTrip, KeepsEveryBitOfRandomNumbers) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 0);
  Scene scene = minimal_scene();
  for (int k = 0; k < 300; ++k) {
    scene.shear.strain_rate = std::pow(10, exponent(random));
    scene.disks.packing_fraction = std::pow(10, exponent(random));
    scene.output.sample_strain = std::pow(10, -exponent(random));
    scene.disks.seed = static_cast<std::int64_t>(random() >> 2);
    ASSERT_TRUE(same(round_trip(scene), scene)) << write_scene(scene);
  }
}

TEST(RoundTrip, KeepsWholeNumbersAndLargeOnes) {
  Scene scene = minimal_scene();
  scene.disks.elasticity = 1e6;
  scene.shear.strain = 1e9;
  scene.output.sample_strain = 1e16;
  scene.output.checkpoint_minutes = std::numeric_limits<double>::max();
  scene.disks.seed = 9'199'999'999'999'999'999;
  scene.measure.every = 1'000'000'000'000;
  scene.output.plot = false;
  scene.start.rescale = false;
  EXPECT_TRUE(same(round_trip(scene), scene)) << write_scene(scene);
}

TEST(RoundTrip, KeepsAnyText) {
  Scene scene = minimal_scene();
  for (std::string const& title : std::vector<std::string>{"\"quoted\"",
                                                           "back\\slash",
                                                           "two\nlines",
                                                           "'single'",
                                                           "\"\"\"",
                                                           "'''",
                                                           "'''\"\"\"",
                                                           "tab\there",
                                                           "carriage\rreturn",
                                                           "\r\n",
                                                           "# no comment",
                                                           "[x]\ny = 1",
                                                           "trailing\\",
                                                           "trailing\"",
                                                           "\n",
                                                           " ",
                                                           "\\n",
                                                           "\\u0041",
                                                           "\x01\x1f\x7f",
                                                           "\b\f",
                                                           "\u03c6 = 0.82",
                                                           "\U0001f980",
                                                           "\"\n'''",
                                                           "\n\"\"\"\"",
                                                           std::string(5000, 'x'),
                                                           "a\n\n\\\nb"}) {
    scene.title = title;
    std::string const text = write_scene(scene);
    try {
      EXPECT_EQ(parse(text).title, title) << text;
    } catch (InputError const& error) {
      ADD_FAILURE() << error.what() << "\n" << text;
    }
  }
}

TEST(RoundTrip, KeepsRandomTextOfAwkwardCharacters) {
  std::vector<std::string> const parts{"\"", "'", "\\", "\n", "\r", "\t",     "#",    "[",
                                       "]",  "=", "a",  " ",  "u",  "\u00e9", "\x02", "\u2028"};
  std::mt19937_64 random(2);
  Scene scene = minimal_scene();
  for (int k = 0; k < 3000; ++k) {
    scene.title.clear();
    for (int length = static_cast<int>(random() % 9); length > 0; --length)
      scene.title += parts[random() % parts.size()];
    std::string const text = write_scene(scene);
    std::string back;
    ASSERT_NO_THROW(back = parse(text).title) << text;
    ASSERT_EQ(back, scene.title) << text;
  }
}

TEST(RoundTrip, KeepsAStateFile) {
  Scene scene = minimal_scene();
  scene.start.kind = "state";
  scene.start.file = "/some folder/a\"b\\c'.h5";
  EXPECT_TRUE(same(round_trip(scene), scene)) << write_scene(scene);
}

TEST(RoundTrip, StateFileIsSoughtBesideTheScene) {
  std::string const state = minimal_text + "[start]\nkind = \"state\"\nfile = ";
  EXPECT_EQ(parse(state + "\"../a/x.h5\"").start.file, "/a/x.h5");
  EXPECT_EQ(parse(state + "\"/b/x.h5\"").start.file, "/b/x.h5");
}

}  // namespace
}  // namespace bagnold
