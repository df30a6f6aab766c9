// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold::fuzz {

/// Ends the process as a finding of the fuzzer.
inline void expect(bool holds, char const* what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

/// A refusal is words for people: some, and none that steer a terminal.
inline void expect_words(std::string_view message) {
  expect(!message.empty(), "a refusal says why");
  auto const steers = [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == 127; };
  expect(std::ranges::none_of(message, steers), "a refusal steers no terminal");
}

/// What holds of the plan of every scene that is accepted.
inline void expect_sound(Scene const& run, Plan const& plan) {
  expect(std::isfinite(plan.time_step) && plan.time_step > 0, "the time step is positive");
  expect(plan.steps > 0 && plan.windows > 0 && plan.window_steps > 0, "there are steps to do");
  expect(plan.window_end(plan.windows - 1) == plan.steps, "windows cover the steps");
  expect(plan.discarded_windows >= 0 && plan.discarded_windows <= plan.windows,
         "at most all windows are discarded");
  expect(plan.frame_steps > 0 && plan.trajectory_steps >= 0, "frames are steps apart");
  if (!plan.ramp)
    expect(plan.strain(plan.steps) >= run.shear.strain.at(0) * (1 - 1e-9), "all strain is spent");
  expect(run.disks.count % 2 == 0 && run.disks.count > 0, "half of the disks are small");
  expect(run.box_length() > 0, "the box has a width");
}

}  // namespace bagnold::fuzz
