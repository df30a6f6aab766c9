// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/make_block_engine.hpp"

#include <utility>

#include "src/engine/blocks/block_engine.hpp"

namespace bagnold {

namespace {

Stepping stepping(EngineInput const& input, BlockStepper const& stepper) {
  auto const& engine = input.engine;
  return stepper.few.empty()             ? Stepping::many_contacts
         : engine == "many-contacts"     ? Stepping::many_contacts
         : engine == "few-contacts"      ? Stepping::few_contacts
         : !input.rates.scales_motions() ? Stepping::many_contacts
         : engine == "lookahead"         ? Stepping::lookahead
                                         : Stepping::automatic;
}

}  // namespace

std::unique_ptr<Simulation> make_block_engine(EngineInput const& input, Snapshot& snapshot,
                                              std::string const& backend, MakeStepper make) {
  auto loop = make_block_loop(backend);
  if (!loop) return nullptr;
  auto stepper = make(input);
  auto const steps = stepping(input, *stepper);
  return std::make_unique<BlockEngine>(std::move(loop), std::move(stepper), steps, input, snapshot);
}

}  // namespace bagnold
