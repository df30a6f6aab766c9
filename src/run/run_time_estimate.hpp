// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Run times on one core, and how they were estimated.
struct RunTimes {
  std::vector<RunTime> each;
  std::string how;

  RunTime sum() const;
};

/// Times of the runs of a scene, in their order, from a trial of a second or two, less if they are
/// short. start: of the first run, if it is given one.
RunTimes times_of_runs(std::vector<Scene> const& runs, std::optional<State> start);

struct PlannedRun {
  Scene scene;
  Plan plan;
};

/// Times of many runs, such as the points of a sweep. Some runs that differ most in what determines
/// the time are tried. The others are given the time per disk and unit of strain of the nearest of
/// these.
RunTimes times_of_many(std::vector<PlannedRun> const& runs);

}  // namespace bagnold
