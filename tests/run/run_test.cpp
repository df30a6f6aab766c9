// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/config/errors.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/state_file.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/folder.hpp"

namespace bagnold {
namespace {

Scene quick_scene() {
  Scene scene;
  scene.disks = {"CD_n", 64, 0.7, 1.0, "area"};
  scene.shear.strain_rate = 1e-2;
  scene.shear.strain = 2.0;
  scene.output.plot = false;
  return scene;
}

constexpr char const* results[] = {"scene.toml", "summary.json", "result.h5", "state.h5",
                                   "checkpoint.h5"};

/// Stops a run once it has stepped, and counts what it is told.
class Impatient final : public RunMonitor {
 public:
  bool stop_requested() override { return stepped_; }
  void progress(std::int64_t) override { stepped_ = true; }
  void finished(RunFolder const&, FinishedRun const&, std::vector<Warning> const&) override {
    ++finished_runs;
  }
  int finished_runs = 0;

 private:
  bool stepped_ = false;
};

TEST(Run, LeavesTheFolderOfTheProgram) {
  io::TestFolder folder;
  EXPECT_EQ(run(quick_scene(), folder.path() / "run"), RunEnd::done);
  for (auto const* name : results)
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "run" / name)) << name;
  EXPECT_EQ(run(quick_scene(), folder.path() / "run"), RunEnd::done);  // nothing is left
  Scene other = quick_scene();
  other.disks.elasticity = 2;
  EXPECT_THROW(run(other, folder.path() / "run"), InputError);
  EXPECT_EQ(run(other, folder.path() / "run", {.replace = true}), RunEnd::done);
}

TEST(Run, GoesOnAfterItWasStopped) {
  io::TestFolder folder;
  auto const whole = folder.path() / "whole", stopped = folder.path() / "stopped";
  Impatient impatient;
  EXPECT_EQ(run(quick_scene(), stopped, {.monitor = &impatient}), RunEnd::stopped);
  EXPECT_EQ(impatient.finished_runs, 0);
  EXPECT_FALSE(std::filesystem::exists(stopped / "summary.json"));
  EXPECT_EQ(resume(stopped), RunEnd::done);
  EXPECT_EQ(resume(stopped), RunEnd::done);  // nothing is left
  EXPECT_EQ(run(quick_scene(), whole), RunEnd::done);
  EXPECT_TRUE(io::same(io::read_states(stopped / "state.h5"), io::read_states(whole / "state.h5")));
}

/// Windows of scheme = "auto" are shorter at small rates than in versions before.
TEST(Run, RefusesWindowsOfAnotherLength) {
  io::TestFolder folder;
  auto const out = folder.path() / "run";
  Scene scene = quick_scene();
  scene.disks = {"CD", 64, 0.82, 1.0, "equal"};
  scene.shear.strain_rate = 1e-6;
  scene.integration.scheme = "auto";
  Impatient impatient;
  EXPECT_EQ(run(scene, out, {.monitor = &impatient}), RunEnd::stopped);
  auto checkpoint = io::newest_checkpoint(out, nullptr).value();
  auto& system = checkpoint.systems.at(0);
  system.window_weight.push_back(1);
  system.window_sums.resize(system.window_weight.size() * static_cast<std::size_t>(system.columns));
  io::write_checkpoint(out, std::move(checkpoint));
  std::filesystem::remove(out / "checkpoint.previous.h5");
  EXPECT_THROW(resume(out), InputError);
}

/// What is measured on frames is told like what is measured in windows.
TEST(Run, TellsAllObservables) {
  struct Reader final : RunMonitor {
    void finished(RunFolder const&, FinishedRun const& run, std::vector<Warning> const&) override {
      for (auto const* name : {"B_p", "band_fraction_phi"}) {
        ASSERT_NE(run.of(name), nullptr) << name;
        EXPECT_EQ(run.mean(name), *run.of(name)->estimate.all.mean);
        EXPECT_TRUE(std::isfinite(run.in_window(name, 0))) << name;
        EXPECT_GT(run.of(name)->sample_strain, 0) << name;
      }
      seen = true;
    }
    bool seen = false;
  };
  io::TestFolder folder;
  Scene scene = quick_scene();
  scene.measure.profiles = true;
  Reader reader;
  EXPECT_EQ(run(scene, folder.path() / "run", {.monitor = &reader}), RunEnd::done);
  EXPECT_TRUE(reader.seen);
}

/// A scene that was never a file is checked as one.
TEST(Run, RefusesASceneBeforeItMakesAFolder) {
  io::TestFolder folder;
  Scene unstable = quick_scene(), nameless = quick_scene(), empty = quick_scene();
  unstable.integration.time_step = 2.5;
  nameless.disks.model = "";
  empty.disks.packing_fraction = 0;
  for (auto const& scene : {unstable, nameless, empty}) {
    EXPECT_THROW(run(scene, folder.path() / "run"), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "run"));
  }
}

}  // namespace
}  // namespace bagnold
