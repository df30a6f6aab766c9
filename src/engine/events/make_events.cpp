// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/make_events.hpp"

#include "src/engine/events/event_engine.hpp"

namespace bagnold {

std::unique_ptr<Simulation> make_events(EngineInput const& input, Snapshot const& snapshot,
                                        std::string const& backend) {
  auto const plan = events::BlockPlan::of(make_block_loop(backend), snapshot.state.count());
  auto const make = [&]<bool rotates>() -> std::unique_ptr<Simulation> {
    auto const material = events::Material<rotates>::of(
        {input.normal_damping, input.tangential_damping}, input.species);
    return std::make_unique<EventEngine<rotates>>(material, input.rates, input.time_step,
                                                  input.skin, snapshot, plan);
  };
  return input.rotates ? make.template operator()<true>() : make.template operator()<false>();
}

}  // namespace bagnold
