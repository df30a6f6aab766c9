// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "src/config/errors.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::io {
namespace {

bool says(FileError const& error, std::string_view part) {
  return std::string_view(error.what()).find(part) != std::string_view::npos;
}

TEST(AtomicFile, ReplacesAndReadsBack) {
  TestFolder folder;
  replace_file(folder / "a", bytes_of("old"));
  replace_file(folder / "a", bytes_of("a longer one"));
  EXPECT_EQ(read_file(folder / "a"), bytes_of("a longer one"));
  replace_file(folder / "a", {});
  EXPECT_TRUE(read_file(folder / "a").empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "a.tmp"));
}

TEST(AtomicFile, DoesNotFollowALinkAtTheTemporary) {
  TestFolder folder;
  replace_file(folder / "victim", bytes_of("mine"));
  std::filesystem::create_symlink(folder / "victim", folder / "a.tmp");
  replace_file(folder / "a", bytes_of("new"));
  EXPECT_EQ(read_file(folder / "victim"), bytes_of("mine"));
  EXPECT_EQ(read_file(folder / "a"), bytes_of("new"));
}

TEST(AtomicFile, LimitOnFileSizesLeavesTheOldFile) {
  TestFolder folder;
  replace_file(folder / "a", bytes_of("old"));
  EXPECT_EQ(in_child([&] {
              std::signal(SIGXFSZ, SIG_IGN);
              rlimit const limit{4096, 4096};
              ::setrlimit(RLIMIT_FSIZE, &limit);
              try {
                replace_file(folder / "a", std::vector<std::byte>(10000));
              } catch (FileError const& error) {
                return says(error, "ulimit -f") ? 0 : 2;
              }
              return 1;
            }),
            0);
  EXPECT_EQ(read_file(folder / "a"), bytes_of("old"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.tmp"));
}

TEST(AtomicFile, UnwritableFolderIsAnErrorThatSaysSo) {
  TestFolder folder;
  replace_file(folder / "a", bytes_of("old"));
  ::chmod(folder.path().c_str(), 0555);
  EXPECT_EQ(in_child([&] {
              // root may write anywhere
              if (::geteuid() == 0 && ::setuid(65534) != 0) return 3;
              try {
                replace_file(folder / "a", bytes_of("new"));
              } catch (FileError const& error) {
                return says(error, "permission") && says(error, folder.path().string()) ? 0 : 2;
              }
              return 1;
            }),
            0);
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(read_file(folder / "a"), bytes_of("old"));
}

TEST(AtomicFile, MissingFolderIsAnError) {
  TestFolder folder;
  EXPECT_THROW(replace_file(folder / "none" / "a", bytes_of("x")), FileError);
}

TEST(AtomicFile, ReadsOnlyRegularFiles) {
  TestFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(read_file(folder / "pipe"), FileError);
  EXPECT_THROW(read_file(folder.path()), FileError);
  EXPECT_THROW(read_file(folder / "missing"), FileError);
  EXPECT_THROW(read_file("/dev/zero"), FileError);
}

TEST(AtomicFile, RefusesAFileBiggerThanMemory) {
  TestFolder folder;
  replace_file(folder / "sparse", bytes_of("x"));
  if (::truncate((folder / "sparse").c_str(), 1LL << 42) != 0) GTEST_SKIP() << "no sparse files";
  EXPECT_THROW(read_file(folder / "sparse"), FileError);
}

}  // namespace
}  // namespace bagnold::io
