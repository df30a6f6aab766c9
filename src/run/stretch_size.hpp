// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace bagnold {

/// Sizes stretches of steps to about 50 ms, so that signals and clocks are checked in time.
class StretchSize {
 public:
  std::int64_t steps() const { return steps_; }

  void took(std::chrono::duration<double> time) {
    if (time.count() < 0.025) steps_ = std::min<std::int64_t>(2 * steps_, 1 << 20);
    if (time.count() > 0.1) steps_ = std::max<std::int64_t>(steps_ / 2, 1);
  }

 private:
  std::int64_t steps_ = 16;
};

}  // namespace bagnold
