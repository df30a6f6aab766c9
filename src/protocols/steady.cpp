// SPDX-License-Identifier: BSD-3-Clause
#include "src/protocols/steady.hpp"

#include <algorithm>
#include <chrono>

namespace bagnold {

namespace {

/// Sizes stretches of steps to about 50 ms, so that signals and clocks are seen in time.
class Stretch {
 public:
  std::int64_t steps() const { return steps_; }

  void took(std::chrono::duration<double> time) {
    if (time.count() < 0.025) steps_ = std::min<std::int64_t>(2 * steps_, 1 << 20);
    if (time.count() > 0.1) steps_ = std::max<std::int64_t>(steps_ / 2, 1);
  }

 private:
  std::int64_t steps_ = 16;
};

}  // namespace

bool run_steady(Simulation& simulation, Plan const& plan, Measurement& measurement,
                std::function<bool()> const& go_on) {
  Stretch stretch;
  Sampling const sampling{plan.window_steps, plan.every, plan.steps};
  if (simulation.step() == 0) measurement.frames.show(simulation, -1);
  while (simulation.step() < plan.steps) {
    auto const start = std::chrono::steady_clock::now();
    auto const from = simulation.step();
    auto const to_frame = measurement.frames.next(from) - from;
    simulation.advance(std::min(stretch.steps(), to_frame), sampling, measurement.open);
    measurement.frames.show(simulation, from);
    while (std::min((measurement.open.first + 1) * plan.window_steps, plan.steps) <=
               simulation.step() &&
           measurement.open.first < plan.windows) {
      WindowSums const done = measurement.open.take_first();
      measurement.windows.push_back(done.sums, done.weight);
    }
    stretch.took(std::chrono::steady_clock::now() - start);
    if (!go_on()) return false;
  }
  return true;
}

}  // namespace bagnold
