// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/run_lock.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <optional>
#include <string>
#include <thread>

#include "src/config/errors.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::io {
namespace {

/// 0: taken; 1: refused, naming the process; 2: refused, naming another.
int try_lock(TestFolder const& folder, ::pid_t holder) {
  try {
    RunLock const lock(folder.path());
  } catch (InputError const& error) {
    auto const pid = "pid " + std::to_string(holder);
    return std::string_view(error.what()).find(pid) != std::string_view::npos ? 1 : 2;
  }
  return 0;
}

TEST(RunLock, AnotherProcessIsToldWhoHoldsIt) {
  TestFolder folder;
  std::optional<RunLock> lock(folder.path());
  auto const self = ::getpid();
  EXPECT_EQ(in_child([&] { return try_lock(folder, self); }), 1);
  lock.reset();
  EXPECT_EQ(in_child([&] { return try_lock(folder, self); }), 0);
}

TEST(RunLock, IsReleasedWhenTheProcessIsKilled) {
  TestFolder folder;
  EXPECT_EQ(in_child([&] {
              auto* const lock = new RunLock(folder.path());  // never released by hand
              ::raise(SIGKILL);
              return lock == nullptr ? 1 : 0;
            }),
            128 + SIGKILL);
  EXPECT_NO_THROW(RunLock(folder.path()));
}

TEST(RunLock, DoesNotSurviveExec) {
  TestFolder folder;
  EXPECT_EQ(in_child([&] {
              RunLock const lock(folder.path());
              // flock belongs to the open file: a sleeping child that kept it would hold it
              if (::fork() == 0) ::execl("/bin/sleep", "sleep", "2", nullptr);
              ::usleep(200000);
              ::_exit(0);
              return 1;
            }),
            0);
  EXPECT_NO_THROW(RunLock(folder.path()));
}

TEST(RunLock, AFolderThatWasMovedIsNotTheirs) {
  TestFolder folder;
  auto const path = folder / "run";
  std::filesystem::create_directory(path);
  RunLock const lock(path);
  EXPECT_NO_THROW(lock.check_folder());
  std::filesystem::rename(path, folder / "moved");
  EXPECT_THROW(lock.check_folder(), FileError);
  std::filesystem::create_directory(path);  // another run's
  EXPECT_THROW(lock.check_folder(), FileError);
  std::filesystem::remove(path);
  std::filesystem::rename(folder / "moved", path);
  EXPECT_NO_THROW(lock.check_folder());
}

TEST(RunLock, IsTakenWhileOthersLook) {
  TestFolder folder;
  { RunLock const makes_the_file(folder.path()); }
  std::atomic<bool> stop = false;
  std::thread look([&] {
    while (!stop) lock_holder(folder.path());
  });
  for (int k = 0; k < 200; ++k) EXPECT_NO_THROW(RunLock(folder.path()));
  stop = true;
  look.join();
}

TEST(RunLock, CanBeDoneWithout) {
  TestFolder folder;
  RunLock const lock(folder.path());
  ::setenv("BAGNOLD_LOCKS", "off", 1);
  EXPECT_NO_THROW(RunLock(folder.path()));
  ::setenv("BAGNOLD_LOCKS", "maybe", 1);
  EXPECT_THROW(RunLock(folder.path()), InputError);
  ::setenv("BAGNOLD_LOCKS", "on", 1);
  EXPECT_THROW(RunLock(folder.path()), InputError);
  ::unsetenv("BAGNOLD_LOCKS");
}

TEST(RunLock, MissingFolderIsAFileError) {
  TestFolder folder;
  EXPECT_THROW(RunLock(folder / "none"), FileError);
}

}  // namespace
}  // namespace bagnold::io
