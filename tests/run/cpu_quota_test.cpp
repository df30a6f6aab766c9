// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/cpu_quota.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/io/folder.hpp"

namespace bagnold {
namespace {

/// A tree with the files of /proc and /sys that tell quotas.
class CpuQuota : public testing::Test {
 protected:
  void put(std::string const& file, std::string const& text) {
    auto const path = root.path() / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  /// Version 2 alone, the group of this process below the mount.
  void unified(std::string const& group, std::string const& top = "/") {
    put("proc/self/cgroup", "0::" + group + "\n");
    put("proc/self/mountinfo", "20 1 8:1 / / rw shared:1 - ext4 /dev/sda1 rw\n30 20 0:26 " + top +
                                   " /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw\n");
  }
  /// Version 1, with a version 2 beside it that has no quota.
  void hybrid(std::string const& group, std::string const& top = "/") {
    put("proc/self/cgroup", "9:name=systemd:/x\n4:memory:/y\n3:cpu,cpuacct:" + group + "\n0::/z\n");
    put("proc/self/mountinfo",
        "31 20 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n"
        "32 31 0:29 " +
            top +
            " /sys/fs/cgroup/cpu,cpuacct rw shared:9 - cgroup cgroup rw,cpu,cpuacct\n"
            "33 31 0:31 / /sys/fs/cgroup/cpuset rw - cgroup cgroup rw,cpuset\n"
            "41 31 0:38 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n");
  }
  double quota() const { return cpu_quota(root.path()); }

  io::TestFolder root;
};

TEST_F(CpuQuota, IsInfiniteWhereNothingIsTold) {
  EXPECT_TRUE(std::isinf(quota()));
  unified("/");
  EXPECT_TRUE(std::isinf(quota()));
  put("sys/fs/cgroup/cpu.max", "max 100000\n");
  EXPECT_TRUE(std::isinf(quota()));
}

TEST_F(CpuQuota, OfVersionTwoIsTheLeastOnTheWayDown) {
  unified("/user.slice/job 7");
  put("sys/fs/cgroup/user.slice/cpu.max", "300000 100000\n");
  EXPECT_EQ(quota(), 3);
  put("sys/fs/cgroup/user.slice/job 7/cpu.max", "50000 20000\n");
  EXPECT_EQ(quota(), 2.5);
  put("sys/fs/cgroup/user.slice/job 7/cpu.max", "max 100000\n");
  EXPECT_EQ(quota(), 3);
  put("sys/fs/cgroup/user.slice/other/cpu.max", "10000 100000\n");
  EXPECT_EQ(quota(), 3) << "that of another group";
}

/// A container sees its group as the top, or names it from the host's.
TEST_F(CpuQuota, OfAContainerIsAtTheMount) {
  put("sys/fs/cgroup/cpu.max", "150000 100000\n");
  unified("/");
  EXPECT_EQ(quota(), 1.5);
  unified("/docker/ab", "/docker/ab");
  EXPECT_EQ(quota(), 1.5);
  unified("/docker/ab/inner", "/docker/ab");
  put("sys/fs/cgroup/inner/cpu.max", "100000 100000\n");
  EXPECT_EQ(quota(), 1);
}

TEST_F(CpuQuota, OfVersionOne) {
  hybrid("/slurm/job_3");
  put("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
  put("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
  EXPECT_TRUE(std::isinf(quota()));
  put("sys/fs/cgroup/cpu,cpuacct/slurm/job_3/cpu.cfs_quota_us", "200000\n");
  put("sys/fs/cgroup/cpu,cpuacct/slurm/job_3/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(quota(), 2);
  put("sys/fs/cgroup/cpu,cpuacct/slurm/cpu.cfs_quota_us", "100000\n");
  put("sys/fs/cgroup/cpu,cpuacct/slurm/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(quota(), 1);
}

TEST_F(CpuQuota, NonsenseIsNone) {
  unified("/a/../b");
  put("sys/fs/cgroup/cpu.max", "0 0\n");
  EXPECT_TRUE(std::isinf(quota()));
  put("sys/fs/cgroup/cpu.max", "many of them\n");
  put("proc/self/cgroup", "::\n:\n0:\n\n");
  EXPECT_TRUE(std::isinf(quota()));
  put("proc/self/mountinfo", " - \n - cgroup2\n");
  EXPECT_TRUE(std::isinf(quota()));
}

}  // namespace
}  // namespace bagnold
