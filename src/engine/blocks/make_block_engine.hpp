// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "kernels/physics/laws/contact.hpp"
#include "src/config/scene.hpp"
#include "src/engine/drives/drive_setup.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

class BlockStepper;

using MakeStepper = std::unique_ptr<BlockStepper> (*)(Scene const&,
                                                      std::optional<DriveSetup> const&);

/// Step of a law on blocks, by the scene's repulsion and scheme (make_stepper.hpp).
template <ContactLaw Law>
std::unique_ptr<BlockStepper> make_stepper(Scene const& scene,
                                           std::optional<DriveSetup> const& drive);

/// Engine on blocks of a scene, from a snapshot, whose arrays it takes; nullptr if the build does
/// not have the backend, or it is not a host backend. make: of the scene's law.
std::unique_ptr<Simulation> make_block_engine(Scene const& scene, Snapshot& snapshot,
                                              std::optional<DriveSetup> const& drive,
                                              std::string const& backend, MakeStepper make);

}  // namespace bagnold
