// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// Scene of one rate of a cascade (P1 Sec. II C), counted from 0: a steady run. From the second on
/// it starts from the last state of the previous rate, `before`, with velocities and spins scaled
/// (P2 Eqs. 40-41).
Scene stage_of(Scene const& cascade, std::size_t stage, std::string const& before);

/// Name of the folder of a stage: "0002_strain_rate=0.0001".
std::string stage_folder(Scene const& cascade, std::size_t stage);

/// Folder names of all stages.
std::vector<std::string> stage_folders(Scene const& cascade);

/// Scenes of all runs of a scene: itself, or the stages of a cascade, each but the first starting
/// from "../FOLDER/state.h5".
std::vector<Scene> runs_of(Scene const& scene);

}  // namespace bagnold
