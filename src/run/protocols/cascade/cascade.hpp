// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "src/config/scene.hpp"
#include "src/run/machine.hpp"
#include "src/run/monitor.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

/// The cascade that a folder is of; nothing where it is of another protocol.
std::optional<Scene> cascade_in(RunFolder const& folder);

/// Runs the stages of a resolved cascade, each in a folder of its own below, those that are not
/// finished; goes on with one that was begun. In the end summary.json names them all.
RunEnd run_cascade(RunFolder const& folder, Scene const& cascade, Machine const& machine,
                   RunMonitor& monitor);

}  // namespace bagnold
