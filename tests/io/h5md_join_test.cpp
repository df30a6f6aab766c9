// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/h5md_join.hpp"

#include <gtest/gtest.h>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_digest.hpp"
#include "src/io/hdf5_memory.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/states.hpp"

namespace bagnold::io {
namespace {

constexpr std::size_t few_disks = 5;

TrajectoryHeader header(double mass = 2.0) {
  return {"1.2.3", std::vector(few_disks, 1.0), std::vector(few_disks, mass), true};
}

/// A part of frames first .. last - 1, each with velocities of its own.
std::vector<std::byte> part(int first, int last, TrajectoryHeader const& header) {
  H5mdFile file(create_in_memory(), header);
  for (int f = first; f < last; ++f)
    file.append(some_state(few_disks, static_cast<unsigned>(f)), f);
  auto const closed = file.close();
  return bytes_of(content_of(closed));
}

std::map<std::string, std::string> hashes(std::vector<std::vector<std::byte>> images) {
  Hdf5Digest digest;
  for (auto& image : images) digest.add(open_in_memory(image));
  return digest.hashes();
}

TEST(Hdf5Digest, IsOfWhatAReaderSees) {
  auto const whole = hashes({part(0, 6, header())});
  EXPECT_TRUE(whole.contains("/h5md/creator@name"));
  EXPECT_TRUE(whole.contains("/particles/trajectory/mass"));
  EXPECT_TRUE(whole.contains("/particles/trajectory/velocity/value"));
  EXPECT_EQ(whole, hashes({part(0, 2, header()), part(2, 6, header())}));
  EXPECT_NE(whole, hashes({part(0, 2, header()), part(3, 6, header())}));
  EXPECT_NE(whole, hashes({part(0, 5, header())}));
  EXPECT_NE(whole, hashes({part(0, 6, header(3.0))}));
}

TEST(JoinH5md, PartsAreOneFile) {
  TestFolder folder;
  std::vector const parts{part(0, 2, header()), part(2, 3, header()), part(3, 6, header())};
  auto const time =
      join_h5md(folder / "t.h5md", header(), 3, [&](std::size_t k) { return parts[k]; });
  EXPECT_EQ(time.size(), 6u);
  EXPECT_EQ(hashes({read_file(folder / "t.h5md")}), hashes(parts));
}

/// As on a disk that keeps something else than it was given: here the parts have another mass.
TEST(JoinH5md, WhatReadsBackDifferentIsRefused) {
  TestFolder folder;
  auto const other = part(0, 2, header(3.0));
  EXPECT_THROW(join_h5md(folder / "t.h5md", header(), 1, [&](std::size_t) { return other; }),
               FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "t.h5md"));
}

}  // namespace
}  // namespace bagnold::io
