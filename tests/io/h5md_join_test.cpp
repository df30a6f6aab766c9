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

/// As many as the number of the frame, modulo 3.
FrameContacts some_contacts(int frame) {
  FrameContacts contacts;
  for (int k = 0; k < frame % 3; ++k) {
    double const x = 10.0 * frame + k;
    contacts.push_back({1,
                        static_cast<std::uint32_t>(2 + k),
                        x + 0.1,
                        {x + 0.2, x + 0.3},
                        {x + 0.4, x + 0.5},
                        x + 0.6,
                        {x + 0.7, x + 0.8},
                        x + 0.9});
  }
  return contacts;
}

/// A part of frames first .. last - 1, each with velocities of its own.
std::vector<std::byte> part(int first, int last, TrajectoryHeader const& header) {
  H5mdFile file(create_in_memory(), header);
  for (int f = first; f < last; ++f)
    file.append(some_state(few_disks, static_cast<unsigned>(f)),
                {.step = f,
                 .strain = 0.1 * f,
                 .images = Images(few_disks, {f, -f}),
                 .contacts = some_contacts(f)});
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

/// In parts of which some have none, and in the file that they are joined into.
TEST(JoinH5md, ContactsBelongToTheirFrames) {
  TestFolder folder;
  auto with_contacts = header();
  with_contacts.contacts = true;
  std::vector const parts{part(0, 1, with_contacts), part(1, 3, with_contacts),
                          part(3, 4, with_contacts), part(4, 9, with_contacts)};
  join_h5md(folder / "t.h5md", with_contacts, parts.size(),
            [&](std::size_t k) { return parts[k]; });
  EXPECT_EQ(hashes({read_file(folder / "t.h5md")}), hashes(parts));
  int frame = 0;
  read_h5md(folder / "t.h5md", [&](State const&, FrameNumbers const& numbers) {
    auto const expected = some_contacts(frame++);
    ASSERT_EQ(numbers.contacts.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      auto const &a = numbers.contacts[k], &b = expected[k];
      EXPECT_TRUE(a.i == b.i && a.j == b.j && a.overlap == b.overlap && a.normal == b.normal &&
                  a.velocity == b.velocity && a.elastic_force == b.elastic_force &&
                  a.dissipative_force == b.dissipative_force && a.age == b.age);
    }
  });
  EXPECT_EQ(frame, 9);
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
