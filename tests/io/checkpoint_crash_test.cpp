// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/state_file.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/states.hpp"

namespace bagnold::io {
namespace {

TEST(CheckpointCrash, KilledAtAnyMomentOneVerifies) {
  TestFolder folder;
  constexpr std::size_t disks = 2000;
  auto const start = std::chrono::steady_clock::now();
  write_checkpoint(folder.path(), some_checkpoint(disks, 1));
  // the kill comes within the first four writes, however slow the disk is
  std::uniform_real_distribution<double> moment(0.0, 4.0);
  std::chrono::duration<double> const one_write = std::chrono::steady_clock::now() - start;
  std::mt19937 random(3);
  std::int64_t last = 1;
  for (int kill = 0; kill < 30; ++kill) {
    auto const child = ::fork();
    if (child == 0) {
      try {
        for (auto step = last + 1;; ++step)
          write_checkpoint(folder.path(), some_checkpoint(disks, step));
      } catch (...) {
        ::_exit(1);  // the child never goes on with the tests
      }
    }
    ASSERT_GT(child, 0);
    std::this_thread::sleep_for(moment(random) * one_write);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "a checkpoint could not be written";

    auto const found = newest_checkpoint(folder.path(), nullptr);
    ASSERT_TRUE(found.has_value());
    EXPECT_GE(found->steps(), last);
    EXPECT_TRUE(same(*found, some_checkpoint(disks, found->steps())));
    last = found->steps();
  }
  EXPECT_GT(last, 5) << "hardly anything was written between the kills";
}

/// A small disk in memory; not mounted where that is not allowed.
class SmallDisk {
 public:
  explicit SmallDisk(std::filesystem::path path) : path_(std::move(path)) {
    std::filesystem::create_directory(path_);
    mounted_ = ::mount("tmpfs", path_.c_str(), "tmpfs", 0, "size=256k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(SmallDisk const&) = delete;
  SmallDisk& operator=(SmallDisk const&) = delete;
  bool mounted() const { return mounted_; }

 private:
  std::filesystem::path path_;
  bool mounted_ = false;
};

TEST(CheckpointCrash, AFullDiskLeavesTheOldOnes) {
  TestFolder folder;
  auto const small = folder / "small";
  SmallDisk const disk(small);
  if (!disk.mounted()) GTEST_SKIP() << "may not mount a tmpfs";

  write_checkpoint(small, some_checkpoint(500, 1));
  write_checkpoint(small, some_checkpoint(500, 2));
  auto const before = read_file(small / "checkpoint.h5");
  try {
    write_checkpoint(small, some_checkpoint(20000, 3));
    FAIL() << "256 kB held 20000 disks";
  } catch (FileError const& error) {
    std::string const message = error.what();
    EXPECT_NE(message.find("No space left on device: free some space, then `bagnold resume " +
                           small.string() + "`"),
              std::string::npos)
        << message;
  }
  EXPECT_FALSE(std::filesystem::exists(small / "checkpoint.h5.tmp"));
  EXPECT_EQ(read_file(small / "checkpoint.h5"), before);
  EXPECT_EQ(newest_checkpoint(small, nullptr).value().steps(), 2);
  EXPECT_THROW(write_states(small / "state.h5", std::vector{some_state(20000)}), FileError);
  EXPECT_FALSE(std::filesystem::exists(small / "state.h5"));
  write_checkpoint(small, some_checkpoint(500, 4));
  EXPECT_EQ(newest_checkpoint(small, nullptr).value().steps(), 4);
}

}  // namespace
}  // namespace bagnold::io
