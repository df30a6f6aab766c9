// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/run_sweep.hpp"

#include <gtest/gtest.h>

#include "src/sweep/collect.hpp"
#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

/// Hears of a sweep, and stops it once so many points have started.
struct Listener final : SweepMonitor {
  bool stop_requested() override { return started_points >= most; }
  void started(std::size_t) override { ++started_points; }
  void finished(std::size_t) override { ++finished_points; }
  void failed(std::size_t) override { ++failed_points; }
  void was_finished(std::size_t) override { ++found_finished; }
  void collected(Sweep const& sweep, SweepFolder const&, Results const& results) override {
    status = results.status;
    suspect = suspect_points(sweep, results, {});
  }
  int most = 1000;
  int started_points = 0, finished_points = 0, failed_points = 0, found_finished = 0;
  std::vector<std::string> status;
  std::string suspect;
};

/// A sweep of three points and a program for them, a script instead of `bagnold`, called as
/// PROGRAM resume FOLDER --threads N.
class RunSweep : public testing::Test {
 protected:
  void program(std::string const& body) {
    auto const file = test_folder / "points.sh";
    std::ofstream(file) << "#!/bin/sh\n" + body;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    options.program = file;
    options.monitor = &listener;
  }
  void finishing_program() {
    program(
        "[ \"$1 $3 $4\" = 'resume --threads 2' ] || exit 2\n"
        "echo '{\"observables\": {\"p\": {\"mean\": 0.5, \"error\": 0.1}},"
        " \"warnings\": [{\"name\": \"deep\"}]}' > \"$2/summary.json\"\n");
    options.machine.threads = 2;
  }

  io::TestFolder test_folder;
  Sweep sweep = expand("[sweep]\ngrid = { \"disks.elasticity\" = [1.0, 2.0, 3.0] }\n");
  std::filesystem::path folder = test_folder / "out";
  Listener listener;
  SweepOptions options;
};

TEST_F(RunSweep, RunsAllPointsAndWritesTheTables) {
  finishing_program();
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::done);
  EXPECT_EQ(listener.finished_points, 3);
  EXPECT_EQ(listener.status, std::vector<std::string>(3, "done"));
  EXPECT_EQ(
      listener.suspect,
      "3 of 3 points are suspect: deep (3); which, and why: column warnings of sweep.csv, and "
      "the points' summary.json");
  EXPECT_TRUE(std::filesystem::exists(folder / "sweep.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "sweep.h5"));
}

TEST_F(RunSweep, GoesOnWhereItEnded) {
  finishing_program();
  EXPECT_EQ(run_chain(sweep, SweepFolder::make(folder, sweep).path(), 2, options), SweepEnd::done);
  EXPECT_EQ(listener.finished_points, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "sweep.csv"));
  EXPECT_EQ(collect(sweep, folder, options), SweepEnd::incomplete);
  EXPECT_EQ(listener.status, (std::vector<std::string>{"open", "done", "open"}));
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::done);
  EXPECT_EQ(listener.found_finished, 1);
  EXPECT_EQ(listener.finished_points, 3);
}

TEST_F(RunSweep, FailedPointsLeaveItIncomplete) {
  program("echo 'bagnold: no such luck'; exit 3\n");
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::incomplete);
  auto const said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("failed with exit code 3: no such luck"), std::string::npos) << said;
  EXPECT_EQ(listener.failed_points, 3);
}

TEST_F(RunSweep, StopsWhereTheMonitorSaysSo) {
  program("trap 'exit 143' TERM\nwhile :; do sleep 0.05; done\n");
  options.jobs = 1;
  listener.most = 1;
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::stopped);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("sweep stopped"), std::string::npos);
  EXPECT_EQ(listener.failed_points, 0);
  EXPECT_TRUE(listener.status.empty()) << "no table of a sweep that was stopped";
}

/// Slurm signals one process after the other: a point may end before the sweep has heard.
TEST_F(RunSweep, APointThatIsStoppedBeforeTheSweepHasNotFailed) {
  struct Late final : SweepMonitor {
    bool stop_requested() override { return ++asked > 4; }
    void failed(std::size_t) override { ++failed_points; }
    int asked = 0, failed_points = 0;
  } late;
  program("kill -TERM $$\n");
  options.jobs = 1;
  options.monitor = &late;
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::stopped);
  auto const said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(said.find("failed with"), std::string::npos) << said;
  EXPECT_EQ(late.failed_points, 0);
}

TEST_F(RunSweep, SeeksItsProgramInPath) {
  options.program = "true";  // ends without results
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(sweep, folder, options), SweepEnd::incomplete);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("exit code 0"), std::string::npos);
}

TEST_F(RunSweep, RefusesChainsThatAreNotThere) {
  EXPECT_THROW(run_chain(sweep, folder, 4, options), InputError);
  EXPECT_THROW(run_chain(sweep, folder, 0, options), InputError);
}

}  // namespace
}  // namespace bagnold::sweep
