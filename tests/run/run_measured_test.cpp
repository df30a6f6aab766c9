// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_measured.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

namespace bagnold {
namespace {

/// Counts steps. A configuration's sums are (its step, 1, its step squared), all exact.
class CountedSteps : public Simulation {
 public:
  explicit CountedSteps(std::int64_t step = 0) : step_(step) {}

  int columns() const override { return 3; }
  std::int64_t step() const override { return step_; }
  Snapshot snapshot() const override { return {}; }
  State state() const override { return {}; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    EXPECT_GT(steps, 0);
    if (pause.count() > 0) std::this_thread::sleep_for(pause);
    stretches.push_back(steps);
    std::int64_t end = (step_ + steps + stops_at - 1) / stops_at * stops_at;
    if (sampling.whole && end > sampling.last_step) end = sampling.last_step / stops_at * stops_at;
    end = std::min(end, sampling.last_step);
    for (; step_ < end; ++step_) {
      if (!sampling.sampled(step_)) continue;
      double const at = static_cast<double>(step_);
      windows.add(sampling.window(step_), std::vector{at, 1.0, at * at}, 1);
      evaluated.insert(step_);
    }
  }

  std::int64_t stops_at = 1;  ///< multiples of this, as an engine does that is ahead of its windows
  std::set<std::int64_t> evaluated;
  std::vector<std::int64_t> stretches;
  std::chrono::milliseconds pause{0};

 private:
  std::int64_t step_;
};

Plan plan_of(std::int64_t steps, std::int64_t window_steps, std::int64_t every) {
  Plan plan;
  plan.time_step = 0.05;
  plan.steps = steps;
  plan.window_steps = window_steps;
  plan.windows = (steps + window_steps - 1) / window_steps;
  plan.every = every;
  return plan;
}

Measurement nothing() { return {.windows = {3, {}, {}}, .open = {}, .frames = Frames{}}; }

auto const forever = [] { return true; };

/// What the windows should hold: one by one, from the plan alone.
statistics::Windows expected_windows(Plan const& plan) {
  statistics::Windows windows{3, {}, {}};
  for (std::int64_t begin = 0; begin < plan.steps; begin += plan.window_steps) {
    std::vector<double> sums(3, 0.0);
    for (std::int64_t s = begin; s < std::min(begin + plan.window_steps, plan.steps);
         s += plan.every) {
      double const at = static_cast<double>(s);
      sums[0] += at;
      sums[1] += 1;
      sums[2] += at * at;
    }
    windows.push_back(sums, sums[1]);
  }
  return windows;
}

void expect_same(statistics::Windows const& a, statistics::Windows const& b) {
  EXPECT_EQ(a.sums, b.sums);
  EXPECT_EQ(a.weight, b.weight);
}

TEST(Steady, WindowsHoldTheirSamples) {
  for (auto const& plan :
       {plan_of(1000, 100, 10), plan_of(1000, 300, 7), plan_of(1, 1, 1), plan_of(10, 3, 100),
        plan_of(100, 1000, 10), plan_of(12345, 1, 1), plan_of(3'000'000, 200'000, 10),
        plan_of(101, 100, 10), plan_of(99, 10, 10)}) {
    CountedSteps simulation;
    Measurement measurement = nothing();
    EXPECT_TRUE(run_measured(simulation, plan, measurement, forever));
    EXPECT_EQ(simulation.step(), plan.steps);
    EXPECT_EQ(static_cast<std::int64_t>(measurement.windows.size()), plan.windows);
    expect_same(measurement.windows, expected_windows(plan));
    EXPECT_TRUE(measurement.open.sums.empty());
  }
}

/// An engine that stops only now and then runs ahead by several windows.
TEST(Steady, WindowsHoldTheirSamplesHoweverCoarselyTheEngineStops) {
  for (auto const& plan : {plan_of(1000, 7, 3), plan_of(1000, 300, 7), plan_of(101, 1, 1)})
    for (std::int64_t stops_at : {2, 16, 100, 333, 5000}) {
      CountedSteps simulation;
      simulation.stops_at = stops_at;
      Measurement measurement = nothing();
      EXPECT_TRUE(run_measured(simulation, plan, measurement, forever));
      EXPECT_EQ(simulation.step(), plan.steps);
      expect_same(measurement.windows, expected_windows(plan));
      EXPECT_TRUE(measurement.open.sums.empty());
    }
}

/// Each window is sampled from its own first step on, whatever `every` does across windows.
TEST(Steady, SamplingStartsAnewInEachWindow) {
  CountedSteps simulation;
  Measurement measurement = nothing();
  run_measured(simulation, plan_of(25, 10, 4), measurement, forever);
  EXPECT_EQ(simulation.evaluated, (std::set<std::int64_t>{0, 4, 8, 10, 14, 18, 20, 24}));
  EXPECT_EQ(measurement.windows.weight, (std::vector{3.0, 3.0, 2.0}));
}

TEST(Steady, StretchesGrowWhileQuick) {
  CountedSteps simulation;
  Measurement measurement = nothing();
  run_measured(simulation, plan_of(2'000'000, 1'000'000, 1000), measurement, forever);
  EXPECT_LT(simulation.stretches.size(), 100u);
}

/// Signals and clocks wait for a stretch: while one takes long, the next is shorter.
TEST(Steady, StretchesShrinkWhileSlow) {
  CountedSteps simulation;
  simulation.pause = std::chrono::milliseconds(110);
  Measurement measurement = nothing();
  int calls = 0;
  EXPECT_FALSE(
      run_measured(simulation, plan_of(1000, 1000, 10), measurement, [&] { return ++calls < 6; }));
  EXPECT_EQ(simulation.stretches, (std::vector<std::int64_t>{16, 8, 4, 2, 1, 1}));
}

TEST(Steady, CuttingIntoStretchesChangesNothing) {
  Plan const plan = plan_of(40, 15, 3);
  CountedSteps quick, slow;
  slow.pause = std::chrono::milliseconds(101);
  Measurement of_quick = nothing(), of_slow = nothing();
  run_measured(quick, plan, of_quick, forever);
  int left = 7;
  run_measured(slow, plan, of_slow, [&] {
    if (--left == 0) slow.pause = std::chrono::milliseconds(0);
    return true;
  });
  EXPECT_NE(quick.stretches, slow.stretches);
  EXPECT_EQ(quick.evaluated, slow.evaluated);
  expect_same(of_quick.windows, of_slow.windows);
}

/// Stopped after each of its stretches in turn and continued with a new simulation at that step.
TEST(Steady, ContinuingFromTheMiddleChangesNothing) {
  Plan const plan = plan_of(5000, 700, 9);
  CountedSteps whole;
  Measurement straight = nothing();
  run_measured(whole, plan, straight, forever);
  ASSERT_GT(whole.stretches.size(), 7u);
  for (std::size_t stop = 1; stop <= whole.stretches.size(); ++stop) {
    CountedSteps first;
    Measurement measurement = nothing();
    std::size_t calls = 0;
    // false, unless it was done in fewer stretches: their size depends on the clock
    bool const done = run_measured(first, plan, measurement, [&] { return ++calls < stop; });
    EXPECT_EQ(done, calls < stop);
    CountedSteps second(first.step());
    EXPECT_TRUE(run_measured(second, plan, measurement, forever));
    expect_same(measurement.windows, straight.windows);
  }
}

TEST(Steady, ADoneRunIsLeftAlone) {
  CountedSteps simulation(100);
  Measurement measurement = nothing();
  EXPECT_TRUE(run_measured(simulation, plan_of(100, 10, 1), measurement, [] { return false; }));
  EXPECT_TRUE(simulation.stretches.empty());
  EXPECT_EQ(measurement.windows.size(), 0u);
}

TEST(Steady, NumericalFailurePassesThrough) {
  struct Failing : CountedSteps {
    void advance(std::int64_t, Sampling const&, OpenWindows&) override {
      throw std::runtime_error("overlap");
    }
  } simulation;
  Measurement measurement = nothing();
  EXPECT_THROW(run_measured(simulation, plan_of(100, 10, 1), measurement, forever),
               std::runtime_error);
  EXPECT_EQ(measurement.windows.size(), 0u);
}

/// A longer run would not stop at the end of this one: what it goes on from lies before, and the
/// windows are those of one leg.
TEST(RunMeasured, AWholeLegStopsWhereALongerRunDoes) {
  Plan const plan = plan_of(1003, 20, 3);
  CountedSteps simulation;
  simulation.stops_at = 64;
  Measurement measurement = nothing();
  EXPECT_TRUE(run_measured(simulation, plan, measurement, forever, LegEnd::whole));
  EXPECT_EQ(simulation.step(), 960);
  EXPECT_EQ(measurement.windows.size(), 48u);
  EXPECT_TRUE(run_measured(simulation, plan, measurement, forever, LegEnd::whole));
  EXPECT_EQ(simulation.step(), 960);
  EXPECT_TRUE(run_measured(simulation, plan, measurement, forever));
  EXPECT_EQ(simulation.step(), 1003);
  expect_same(measurement.windows, expected_windows(plan));
}

/// Several systems, each at a stop of its own.
TEST(RunMeasured, AWholeLegOfSeveral) {
  Plan const plan = plan_of(1000, 20, 3);
  CountedSteps one, other;
  one.stops_at = 64;
  other.stops_at = 100;
  Measurement first = nothing(), second = nothing();
  MeasuredSystem const systems[] = {{one, first}, {other, second}};
  EXPECT_TRUE(run_measured(systems, plan, forever, LegEnd::whole));
  EXPECT_EQ(one.step(), 960);
  EXPECT_EQ(other.step(), 1000);
}

}  // namespace
}  // namespace bagnold
