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

/// What runs take on one core, and how that was found.
struct RunTimes {
  std::vector<RunTime> each;
  std::string how;

  RunTime sum() const;
};

/// Of the runs of a scene, in their order, the first of them from `start` where that is given: from
/// a trial of a second or two, less where they are short.
RunTimes times_of_runs(std::vector<Scene> const& runs, std::optional<State> start);

struct PlannedRun {
  Scene scene;
  Plan plan;
};

/// Of many runs, as of the points of a sweep: from trials of some that lie far apart in what
/// decides the time. The others take, for each disk and unit of strain, what the nearest of these
/// do.
RunTimes times_of_many(std::vector<PlannedRun> const& runs);

}  // namespace bagnold
