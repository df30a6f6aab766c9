// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "src/config/errors.hpp"
#include "src/io/hdf5_reader.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::io {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
std::vector<double> const odd_numbers{-0.0,
                                      std::numeric_limits<double>::denorm_min(),
                                      std::numeric_limits<double>::quiet_NaN(),
                                      -infinity,
                                      0.1,
                                      std::numeric_limits<double>::max()};

std::vector<std::byte> sample(Hashed hashed) {
  Hdf5Writer file(hashed);
  file.group("/g");
  file.dataset("/g/d", odd_numbers, {3, 2}, {{"unit", "d_s"}, {"n", std::int64_t{1} << 62}});
  file.dataset("/g/i", std::vector<std::int64_t>{(std::int64_t{1} << 53) + 1, -5}, {2});
  file.dataset("/g/b", std::vector<std::uint8_t>{1, 2, 255}, {3});
  file.dataset("/g/none", std::vector<double>{}, {0, 4});
  file.text("/g/t", std::string(100000, 'x') + "\u03b3\u0307");
  file.text("/g/empty", "");
  file.attribute("/", "name", "shear");
  file.attribute("/", "zero", -0.0);
  return bytes_of(file.content());
}

TEST(Hdf5, RoundTripKeepsEveryBit) {
  for (auto const hashed : {Hashed::no, Hashed::yes}) {
    Hdf5Reader const file("x.h5", sample(hashed), hashed);
    EXPECT_TRUE(same(file.doubles("/g/d", {3, 2}), odd_numbers));
    EXPECT_EQ(file.integers("/g/i", {2}).front(), (std::int64_t{1} << 53) + 1);
    EXPECT_TRUE(file.doubles("/g/none", {0, 4}).empty());
    EXPECT_EQ(file.text("/g/t").size(), 100004u);
    EXPECT_EQ(file.text("/g/empty"), "");
    EXPECT_EQ(file.integer("/g/d", "n"), std::int64_t{1} << 62);
    EXPECT_EQ(file.words_of("/", "name"), "shear");
    EXPECT_TRUE(same(file.number("/", "zero"), -0.0));
    EXPECT_EQ(file.shape("/g/d"), (Shape{3, 2}));
    EXPECT_EQ(file.attribute_names("/"), (std::vector<std::string>{"name", "zero"}));
    EXPECT_FALSE(file.has("/g/q"));
    EXPECT_FALSE(file.has("/q/q"));
  }
}

TEST(Hdf5, NarrowTypesAreWidened) {
  Hdf5Reader const file("x.h5", sample(Hashed::no));
  EXPECT_EQ(file.doubles("/g/b", {3}), (std::vector<double>{1.0, 2.0, 255.0}));
}

TEST(Hdf5, ReadingThatWouldChangeANumberIsRefused) {
  Hdf5Reader const file("x.h5", sample(Hashed::no));
  EXPECT_THROW(file.doubles("/g/i", {2}), InputError);      // 2^53 + 1
  EXPECT_THROW(file.integers("/g/d", {3, 2}), InputError);  // 0.1
  EXPECT_THROW((void)file.integer("/", "zero"), InputError);
}

TEST(Hdf5, EqualContentGivesEqualBytes) {
  auto const first = sample(Hashed::yes);
  std::vector<std::byte> noise(first.size() * 4, std::byte{0xa5});  // dirt for malloc to give out
  noise = {};
  EXPECT_EQ(first, sample(Hashed::yes));
}

TEST(Hdf5, HashTellsAChangedValue) {
  auto image = sample(Hashed::yes);
  auto const raw = std::as_bytes(std::span(odd_numbers));
  auto const found = std::search(image.begin(), image.end(), raw.begin(), raw.end());
  ASSERT_NE(found, image.end());
  found[3] ^= std::byte{1};
  EXPECT_THROW(Hdf5Reader("x.h5", image, Hashed::yes).doubles("/g/d", {3, 2}), InputError);
  EXPECT_NO_THROW(Hdf5Reader("x.h5", image, Hashed::no).doubles("/g/d", {3, 2}));
}

TEST(Hdf5, FilesOpenAtOnceKeepApart) {
  auto const image_of = [](double value) {
    Hdf5Writer file;
    file.dataset("/d", std::vector{value}, {1});
    return bytes_of(file.content());
  };
  Hdf5Writer writer;
  writer.dataset("/d", std::vector{3.0}, {1});
  Hdf5Reader const one("one.h5", image_of(1.0)), two("two.h5", image_of(2.0));
  Hdf5Reader const three("three.h5", bytes_of(writer.content()));
  EXPECT_EQ(two.doubles("/d", {1}), std::vector{2.0});
  EXPECT_EQ(one.doubles("/d", {1}), std::vector{1.0});
  EXPECT_EQ(three.doubles("/d", {1}), std::vector{3.0});
}

TEST(Hdf5, WhatIsMissingIsNamed) {
  Hdf5Reader const file("x.h5", sample(Hashed::no));
  auto const message = [&](auto what) -> std::string {
    try {
      what();
    } catch (InputError const& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([&] { file.doubles("/g/q", {3}); }),
            "x.h5: /g/q is missing: write this dataset");
  EXPECT_EQ(message([&] { (void)file.number("/g", "q"); }),
            "x.h5: /g@q is missing: write this attribute");
  EXPECT_NE(message([&] { (void)file.number("/q", "q"); }).find("/q is missing"),
            std::string::npos);
  EXPECT_NE(message([&] { file.doubles("/g/d", {6}); }).find("[3][2] (must be [6])"),
            std::string::npos);
}

}  // namespace
}  // namespace bagnold::io
