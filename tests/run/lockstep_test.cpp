// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "src/engine/ensemble/ensemble.hpp"
#include "src/run/run_measured.hpp"

namespace bagnold {
namespace {

/// Systems that count steps together. System s adds (s, step) for each sample; its time is its
/// step.
class CountedTogether final : public Ensemble {
 public:
  explicit CountedTogether(std::vector<std::int64_t> steps)
      : step_(std::move(steps)), pending_(step_.size()) {}

  std::size_t systems() const override { return step_.size(); }
  int columns() const override { return 2; }
  std::int64_t step(std::size_t s) const override { return step_[s]; }
  Snapshot snapshot(std::size_t) const override { return {}; }

  State state(std::size_t s) const override {
    State state;
    state.time = static_cast<double>(step_[s]);
    state.offset = static_cast<double>(s);
    return state;
  }

  void advance(std::int64_t end, Sampling const& sampling) override {
    bool behind = false;
    for (std::size_t s = 0; s < step_.size(); ++s) {
      behind = behind || step_[s] < end;
      for (; step_[s] < end; ++step_[s])
        if (sampling.sampled(step_[s]))
          pending_[s].add(sampling.window(step_[s]),
                          std::vector{static_cast<double>(s), static_cast<double>(step_[s])}, 1);
    }
    launches += behind;
  }

  void take_samples(std::size_t s, OpenWindows& windows) override {
    for (std::size_t w = 0; w < pending_[s].sums.size(); ++w)
      if (pending_[s].sums[w].weight > 0)
        windows.add(static_cast<std::int64_t>(w), pending_[s].sums[w].sums,
                    pending_[s].sums[w].weight);
    pending_[s] = {};
    if (s == fails && step_[s] > 50) throw NumericalError("overlap");
  }

  std::size_t fails = 1000;
  int launches = 0;

 private:
  std::vector<std::int64_t> step_;
  std::vector<OpenWindows> pending_;
};

/// Sees that each frame is of its own system, at the step at which it is due.
class SeesItsSystem final : public FrameObserver {
 public:
  SeesItsSystem(std::size_t system, std::vector<std::int64_t>& seen)
      : system_(system), seen_(seen) {}
  void add(Frame const& frame) override {
    EXPECT_EQ(frame.state.offset, static_cast<double>(system_));
    EXPECT_EQ(frame.state.time, static_cast<double>(frame.step));
    seen_.push_back(frame.step);
  }
  void save(ObserverState&) override {}
  void load(ObserverState const&) override {}
  void report(std::vector<FrameObserver const*> const&, FrameResults&) const override {}

 private:
  std::size_t system_;
  std::vector<std::int64_t>& seen_;
};

/// An ensemble in a run of 1000 steps, windows of 300 sampled every 7, frames every 130.
class Lockstep : public testing::Test {
 public:
  explicit Lockstep(std::vector<std::int64_t> steps = {0, 0, 0})
      : ensemble(std::make_shared<CountedTogether>(std::move(steps))),
        members(members_of(ensemble)),
        measurements(members.size()),
        frames(members.size()) {
    plan.time_step = 0.05;
    plan.steps = 1000;
    plan.window_steps = 300;
    plan.windows = 4;
    plan.every = 7;
    for (std::size_t s = 0; s < members.size(); ++s) {
      measurements[s].windows.columns = 2;
      measurements[s].frames.add_observer(std::make_unique<SeesItsSystem>(s, frames[s]), 130);
      systems.push_back({*members[s], measurements[s]});
    }
  }

  std::shared_ptr<CountedTogether> ensemble;
  std::vector<std::unique_ptr<Simulation>> members;
  std::vector<Measurement> measurements;
  std::vector<std::vector<std::int64_t>> frames;
  std::vector<MeasuredSystem> systems;
  Plan plan;
};

TEST_F(Lockstep, EachSystemHasItsWindowsAndFrames) {
  int looks = 0;
  EXPECT_TRUE(run_measured(systems, plan, [&] {
    ++looks;
    for (auto const& member : members) EXPECT_EQ(member->step(), members[0]->step());
    return true;
  }));
  EXPECT_EQ(ensemble->launches, looks) << "one takes all others along";
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(frames[s], (std::vector<std::int64_t>{0, 130, 260, 390, 520, 650, 780, 910}));
    auto const& windows = measurements[s].windows;
    EXPECT_EQ(windows.weight, (std::vector{43.0, 43.0, 43.0, 15.0}));
    for (std::size_t w = 0; w < 4; ++w) {
      double steps = 0;
      for (std::size_t k = 0; k < (w < 3 ? 43u : 15u); ++k)
        steps += static_cast<double>(300 * w + 7 * k);
      EXPECT_EQ(windows.row(w)[0], windows.weight[w] * static_cast<double>(s));
      EXPECT_EQ(windows.row(w)[1], steps);
    }
    EXPECT_TRUE(measurements[s].open.sums.empty());
  }
}

TEST_F(Lockstep, AFailureNamesItsSystem) {
  ensemble->fails = 2;
  try {
    run_measured(systems, plan, [] { return true; });
    FAIL() << "no failure";
  } catch (SystemFailure const& failure) {
    EXPECT_EQ(failure.system, 2u);
    EXPECT_STREQ(failure.what(), "overlap");
    EXPECT_GT(members[2]->step(), 50);
  }
}

TEST_F(Lockstep, NobodyGoesOnWhereToldToStop) {
  int looks = 0;
  EXPECT_FALSE(run_measured(systems, plan, [&] { return ++looks < 3; }));
  EXPECT_EQ(ensemble->launches, 3);
  for (auto const& member : members) EXPECT_EQ(member->step(), members[0]->step());
}

/// Those that had come further wait for the others.
struct FromDifferentSteps : Lockstep {
  FromDifferentSteps() : Lockstep({600, 0, 45}) {
    measurements[0].windows.push_back(std::vector{0.0, 0.0}, 1);
    measurements[0].windows.push_back(std::vector{0.0, 0.0}, 1);
    measurements[0].open.first = 2;
  }
};

TEST_F(FromDifferentSteps, AllComeToTheEnd) {
  EXPECT_TRUE(run_measured(systems, plan, [] { return true; }));
  for (auto const& member : members) EXPECT_EQ(member->step(), 1000);
  EXPECT_EQ(frames[0], (std::vector<std::int64_t>{650, 780, 910}));
  EXPECT_EQ(frames[2], (std::vector<std::int64_t>{130, 260, 390, 520, 650, 780, 910}));
  EXPECT_EQ(measurements[0].windows.weight, (std::vector{1.0, 1.0, 43.0, 15.0}));
  EXPECT_EQ(measurements[1].windows.weight, (std::vector{43.0, 43.0, 43.0, 15.0}));
  EXPECT_EQ(measurements[2].windows.weight, (std::vector{36.0, 43.0, 43.0, 15.0}));
}

}  // namespace
}  // namespace bagnold
