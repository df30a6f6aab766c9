// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>

#include "src/engine/simulation.hpp"

namespace bagnold {

/// CPU time of this thread, [s].
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Sizes stretches of steps to about 50 ms, so that signals and clocks are checked in time.
class StretchSize {
 public:
  std::int64_t steps() const { return steps_; }

  void took(std::chrono::duration<double> time) {
    if (time.count() < 0.025) steps_ = std::min<std::int64_t>(2 * steps_, 1 << 20);
    if (time.count() > 0.1) steps_ = std::max<std::int64_t>(steps_ / 2, 1);
  }

  /// Steps to sampling.last_step. Returns false if go_on, asked after each stretch, did.
  template <class GoOn>
  bool step(Simulation& simulation, Sampling const& sampling, OpenWindows& windows,
            GoOn const& go_on) {
    while (simulation.step() < sampling.last_step) {
      auto const begun = std::chrono::steady_clock::now();
      simulation.advance(std::min(steps_, sampling.last_step - simulation.step()), sampling,
                         windows);
      took(std::chrono::steady_clock::now() - begun);
      if (!go_on()) return false;
    }
    return true;
  }

 private:
  std::int64_t steps_ = 16;
};

}  // namespace bagnold
