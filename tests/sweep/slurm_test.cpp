// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/slurm.hpp"

#include <gtest/gtest.h>

#include "src/sweep/slurm_limit.hpp"
#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

TEST(ArrayTasks, AreOneLessThanMaxArraySize) {
  EXPECT_EQ(most_array_tasks("Foo = 1\nMaxArraySize            = 1001\nMaxDBDMsgs = 20008\n"),
            1000);
  EXPECT_EQ(most_array_tasks("MaxArraySize            = 1000\n"), 999);
  EXPECT_EQ(most_array_tasks("MaxArraySize = 4000001\n"), 4000000);
  EXPECT_EQ(most_array_tasks("XMaxArraySize = 7\n"), 1000);
}

TEST(ArrayTasks, MayBeFewerByTheScheduler) {
  EXPECT_EQ(most_array_tasks("MaxArraySize = 1001\nSchedulerParameters     = max_array_tasks=50\n"),
            50);
  EXPECT_EQ(most_array_tasks("MaxArraySize = 1001\nSchedulerParameters     = "
                             "bf_interval=30,max_array_tasks=500,x\n"),
            500);
  EXPECT_EQ(most_array_tasks("MaxArraySize = 11\nSchedulerParameters = max_array_tasks=500\n"), 10);
}

TEST(ArrayTasks, AreAThousandWhereNobodyTells) {
  EXPECT_EQ(most_array_tasks(""), 1000);
  EXPECT_EQ(most_array_tasks("slurm_load_ctl_conf error: Unable to contact slurm controller\n"),
            1000);
  EXPECT_EQ(most_array_tasks("MaxArraySize = 0\n"), 1) << "arrays are off: sbatch will say so";
}

/// Bash runs the script with stand-ins for srun and scontrol: which chains each task would run.
class Script : public testing::Test {
 protected:
  void SetUp() override {
    std::string seeds;
    for (int k = 1; k <= 7; ++k) seeds += (k > 1 ? ", " : "") + std::to_string(k);
    sweep = expand("[sweep]\ngrid = { \"disks.seed\" = [" + seeds + "] }\n");
    job.program = "bagnold";
    job.seconds.assign(sweep.points.size(), 1.0);
  }
  /// Of an array from `least` to `most` with `count` tasks.
  std::string chains(int task, int least, int most, int count) {
    auto const file = folder / "points.slurm", out = folder / "out";
    std::ofstream(file) << slurm_array(sweep, job);
    auto const line =
        "cd " + folder.path().string() +
        " && : > out && srun() { echo -n \"${@: -2:1} \" >> out; } && export -f srun && "
        "SLURM_ARRAY_JOB_ID=5 SLURM_ARRAY_TASK_ID=" +
        std::to_string(task) + " SLURM_ARRAY_TASK_MIN=" + std::to_string(least) +
        " SLURM_ARRAY_TASK_MAX=" + std::to_string(most) +
        " SLURM_ARRAY_TASK_COUNT=" + std::to_string(count) + " bash points.slurm";
    EXPECT_EQ(std::system(("bash -c '" + line + "'").c_str()), 0);
    std::ifstream in(out);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  io::TestFolder folder;
  Sweep sweep;
  SlurmJob job;
};

TEST_F(Script, ATaskAChain) {
  EXPECT_EQ(slurm_tasks(sweep, job), 7u);
  EXPECT_EQ(chains(1, 1, 7, 7), "1 ");
  EXPECT_EQ(chains(7, 1, 7, 7), "7 ");
}

TEST_F(Script, FewerTasksThanChains) {
  job.most_tasks = 3;
  EXPECT_EQ(slurm_tasks(sweep, job), 3u);
  EXPECT_NE(slurm_array(sweep, job).find("#SBATCH --array=1-3\n"), std::string::npos);
  EXPECT_EQ(chains(1, 1, 3, 3), "1 4 7 ");
  EXPECT_EQ(chains(3, 1, 3, 3), "3 6 ");
}

TEST_F(Script, UnstableStepsAreAcceptedInBoth) {
  EXPECT_EQ(slurm_collect(job).find("--allow-unstable"), std::string::npos);
  job.allow_unstable = true;
  EXPECT_NE(slurm_array(sweep, job).find(" --allow-unstable --chain"), std::string::npos);
  EXPECT_NE(slurm_collect(job).find(" --allow-unstable --collect"), std::string::npos);
}

TEST_F(Script, AsTheArrayWasSubmitted) {
  EXPECT_EQ(chains(1, 1, 2, 2), "1 3 5 7 ");
  EXPECT_EQ(chains(2, 1, 2, 2), "2 4 6 ");
  EXPECT_EQ(chains(0, 0, 2, 3), "1 4 7 ");
  EXPECT_EQ(chains(2, 0, 2, 3), "3 6 ");
  EXPECT_EQ(chains(9, 1, 9, 9), "");
}

TEST_F(Script, AListOfTasksRunsWhatItNames) {
  EXPECT_EQ(chains(5, 2, 5, 2), "5 ");
  EXPECT_EQ(chains(3, 3, 3, 1), "3 ");
  EXPECT_EQ(chains(3, 1, 7, 4), "3 ");
  job.most_tasks = 3;
  EXPECT_EQ(chains(2, 2, 3, 2), "2 5 ");
}

}  // namespace
}  // namespace bagnold::sweep
