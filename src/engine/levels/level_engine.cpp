// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each level, with its instructions: BAGNOLD_LEVEL is its name.
#include "src/engine/levels/level_engine.hpp"

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/engine/blocks/make_block_engine.hpp"

namespace bagnold::BAGNOLD_LEVEL {

std::unique_ptr<Simulation> make_block_engine(Scene const& scene, Snapshot& snapshot,
                                              std::optional<DriveSetup> const& drive,
                                              std::string const& backend) {
  MakeStepper const make = with_named<Laws>(
      scene.disks.model,
      []<class Law>(std::type_identity<Law>) -> MakeStepper { return &make_stepper<Law>; });
  return bagnold::make_block_engine(scene, snapshot, drive, backend, make);
}

}  // namespace bagnold::BAGNOLD_LEVEL
