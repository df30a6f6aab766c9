// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/config/scene.hpp"
#include "src/run/machine.hpp"
#include "src/run/monitor.hpp"
#include "src/run/run_folder.hpp"
#include "src/start/start.hpp"

namespace bagnold {

/// First states of a scene that reads them from a file, [R]; empty if random starts are yet to be
/// made.
std::vector<StartedState> states_in_file(Scene const& scene);

/// Runs a resolved scene of one run from its beginning, in a folder made for it.
RunEnd run_from_start(RunFolder const& folder, Scene const& scene, Machine const& machine,
                      RunMonitor& monitor, std::vector<StartedState> started);

/// Continues the run in a folder from its newest checkpoint that verifies, or from the beginning if
/// none does. A scene.toml with more strain than the checkpoint's makes the run longer.
RunEnd go_on_in(RunFolder const& folder, Machine const& machine, RunMonitor& monitor);

}  // namespace bagnold
