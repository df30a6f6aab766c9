// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "kernels/physics/laws/contact.hpp"
#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

class BlockStepper;

using MakeStepper = std::unique_ptr<BlockStepper> (*)(EngineInput const&);

/// Step of a law on blocks, by the repulsion and the scheme of an input (make_stepper.hpp).
template <ContactLaw Law>
std::unique_ptr<BlockStepper> make_stepper(EngineInput const& input);

/// Engine on blocks, from a snapshot, whose arrays it takes; nullptr if the build does not have the
/// backend, or it is not a host backend. make: of the law of the input.
std::unique_ptr<Simulation> make_block_engine(EngineInput const& input, Snapshot& snapshot,
                                              std::string const& backend, MakeStepper make);

}  // namespace bagnold
