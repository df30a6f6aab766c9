// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "src/config/scene.hpp"
#include "src/run/machine.hpp"
#include "src/run/monitor.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

/// Cascade of a folder; nothing if its protocol is another one.
std::optional<Scene> cascade_in(RunFolder const& folder);

/// Runs the unfinished stages of a resolved cascade, each in a folder of its own below; continues
/// one that has begun. In the end summary.json names them all.
RunEnd run_cascade(RunFolder const& folder, Scene const& cascade, Machine const& machine,
                   RunMonitor& monitor);

/// Draws the pictures of a finished cascade that are not there.
void draw_missing_pictures_of_cascade(RunFolder const& folder, Scene const& cascade);

/// A folder of one rate of a cascade.
struct StageFolder {
  std::filesystem::path cascade;  ///< its folder
  Scene scene;                    ///< of the cascade
  std::size_t stage = 0;

  bool is_last() const { return stage + 1 == scene.shear.strain_rates.size(); }
};
std::optional<StageFolder> stage_folder_in_cascade(std::filesystem::path const& folder);

/// Folder for `bagnold resume` to continue a run: for a rate of a cascade the cascade's folder.
std::filesystem::path folder_to_resume(std::filesystem::path const& folder);

/// True if the scene of a finished cascade has more strain at its last rate than its run, or
/// further rates after it. Throws InputError where it has more strain at a rate before, or another
/// rate.
bool asks_for_more(RunFolder const& folder, Scene const& cascade);

/// Prepares the folder of a cascade for run_cascade() with more strain at its last rate. Throws
/// InputError, nothing changed, where that stage cannot be made longer (make_longer.hpp).
void make_cascade_longer(RunFolder const& folder, Scene const& after);

}  // namespace bagnold
