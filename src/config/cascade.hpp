// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// The run at one rate of a cascade (P1 Sec. II C), from 0 on: steady, and from the second on from
/// the last state of the one before, velocities and spins scaled (P2 Eqs. 40-41). `before` is that
/// state's file.
Scene stage_of(Scene const& cascade, std::size_t stage, std::string const& before);

/// Name of the folder of a stage: "0002_strain_rate=0.0001".
std::string stage_folder(Scene const& cascade, std::size_t stage);

/// Of all stages.
std::vector<std::string> stage_folders(Scene const& cascade);

/// The scenes of all runs of a scene: itself, or the stages of a cascade, each but the first
/// starting from "../FOLDER/state.h5".
std::vector<Scene> runs_of(Scene const& scene);

}  // namespace bagnold
