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
  while (simulation.step() < plan.steps) {
    auto const start = std::chrono::steady_clock::now();
    std::int64_t const origin = simulation.step() / plan.window_steps * plan.window_steps;
    std::int64_t const end = std::min(origin + plan.window_steps, plan.steps);
    simulation.advance(std::min(end - simulation.step(), stretch.steps()), {origin, plan.every},
                       measurement.open);
    if (simulation.step() == end) {
      measurement.windows.push_back(measurement.open.sums, measurement.open.weight);
      measurement.open = {};
    }
    stretch.took(std::chrono::steady_clock::now() - start);
    if (!go_on()) return false;
  }
  return true;
}

}  // namespace bagnold
