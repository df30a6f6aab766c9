// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/measure/frames.hpp"

namespace bagnold {

/// Observers of a scene, for a system that starts from this state: those in `measure` from the end
/// of the discarded strain on, the trajectory from step 0 on. trajectory: its file, NAME.h5md.
/// version: of Bagnold.
Frames make_frames(Scene const& scene, Plan const& plan, State const& start,
                   std::filesystem::path const& trajectory, std::string const& version);

}  // namespace bagnold
