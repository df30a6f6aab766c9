// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each level, with its instructions: BAGNOLD_LEVEL is its name.
#include "src/engine/levels/level_engine.hpp"

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/engine/blocks/make_block_engine.hpp"

namespace bagnold::BAGNOLD_LEVEL {

std::unique_ptr<Simulation> make_block_engine(EngineInput const& input, Snapshot& snapshot,
                                              std::string const& backend) {
  MakeStepper const make = with_named<Laws>(
      input.model,
      []<class Law>(std::type_identity<Law>) -> MakeStepper { return &make_stepper<Law>; });
  return bagnold::make_block_engine(input, snapshot, backend, make);
}

}  // namespace bagnold::BAGNOLD_LEVEL
