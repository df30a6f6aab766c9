// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/frames.hpp"

#include <gtest/gtest.h>

namespace bagnold {
namespace {

/// Stops at multiples of 7 only.
class Sevens final : public Simulation {
 public:
  int columns() const override { return 1; }
  std::int64_t step() const override { return step_; }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows&) override {
    for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;)
      step_ = std::min((step_ / 7 + 1) * 7, sampling.last_step);
  }
  Snapshot snapshot() const override { return {}; }
  State state() const override { return {}; }

 private:
  std::int64_t step_ = 0;
};

class Steps final : public FrameObserver {
 public:
  explicit Steps(std::vector<std::int64_t>& seen) : seen_(seen) {}
  void add(Frame const& frame) override {
    seen_.push_back(frame.step);
    EXPECT_DOUBLE_EQ(frame.strain, 0.5 * static_cast<double>(frame.step));
  }
  void save(ObserverState&) override {}
  void load(ObserverState const&) override {}
  void forget_before(double strain) override {
    std::erase_if(seen_, [&](auto step) { return 0.5 * static_cast<double>(step) < strain; });
  }
  void report(std::vector<FrameObserver const*> const&, FrameResults&) const override {}

 private:
  std::vector<std::int64_t>& seen_;
};

/// Runs to the end in calls of so many steps, and shows each stop; then(step) follows.
template <class Then>
void show_run(Frames& frames, std::int64_t end, std::int64_t steps, Then const& then) {
  Sevens simulation;
  OpenWindows windows;
  Sampling sampling;
  sampling.last_step = end;
  for (std::int64_t from = 0; from < end; from = simulation.step()) {
    simulation.advance(std::min(steps, frames.next(from) - from), sampling, windows);
    frames.show(simulation, from);
    then(simulation.step());
  }
}

std::vector<std::vector<std::int64_t>> seen_in_calls_of(std::int64_t steps) {
  std::vector<std::vector<std::int64_t>> seen(3);
  Frames frames(Plan{.time_step = 0.5, .strain_rate = 1});
  frames.add_observer(std::make_unique<Steps>(seen[0]), 10);
  frames.add_observer(std::make_unique<Steps>(seen[1]), 10, 40);
  frames.add_observer(std::make_unique<Steps>(seen[2]), 3, 60);
  frames.show(Sevens(), -1);
  show_run(frames, 75, steps, [](std::int64_t) {});
  return seen;
}

TEST(Frames, AreTheFirstStopsFromEachMultipleOn) {
  auto const seen = seen_in_calls_of(1);
  EXPECT_EQ(seen[0], (std::vector<std::int64_t>{0, 14, 21, 35, 42, 56, 63, 70}));
  EXPECT_EQ(seen[1], (std::vector<std::int64_t>{42, 56, 63, 70}));
  EXPECT_EQ(seen[2], (std::vector<std::int64_t>{63, 70, 75}));
}

TEST(Frames, DoNotDependOnHowTheRunIsCut) {
  for (std::int64_t const steps : {2, 5, 8, 30, 1000})
    EXPECT_EQ(seen_in_calls_of(steps), seen_in_calls_of(1)) << steps;
}

/// One that measures begins anew; one that sees the whole run, as a trajectory, goes on.
TEST(Frames, BeginAnew) {
  std::vector<std::vector<std::int64_t>> seen(3);
  Frames frames(Plan{.time_step = 0.5, .strain_rate = 1});
  frames.add_observer(std::make_unique<Steps>(seen[0]), 7);
  frames.add_observer(std::make_unique<Steps>(seen[1]), 7, 14);
  frames.add_observer(std::make_unique<Steps>(seen[2]), 7, 63);
  show_run(frames, 70, 7, [&](std::int64_t step) {
    if (step == 28) frames.forget_before(42);
  });
  EXPECT_EQ(seen[0], (std::vector<std::int64_t>{7, 14, 21, 28, 35, 42, 49, 56, 63, 70}));
  EXPECT_EQ(seen[1], (std::vector<std::int64_t>{42, 49, 56, 63, 70}));
  EXPECT_EQ(seen[2], (std::vector<std::int64_t>{63, 70}));
}

}  // namespace
}  // namespace bagnold
