// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/make_events.hpp"

#include "src/config/laws.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/events/event_engine.hpp"

namespace bagnold {

std::unique_ptr<Simulation> make_events(Scene const& scene, Snapshot const& snapshot,
                                        std::string const& backend) {
  auto const constants = law_of(scene.disks).constants(scene.disks);
  auto const table = make_species_table(scene.mass_by_area());
  auto const plan = events::BlockPlan::of(make_block_loop(backend), snapshot.state.count());
  auto const make = [&]<bool rotates>() -> std::unique_ptr<Simulation> {
    auto const material =
        events::Material<rotates>::of({constants.normal, constants.tangential}, table);
    return std::make_unique<EventEngine<rotates>>(material, strain_rates(scene), time_step(scene),
                                                  skin(scene), snapshot, plan);
  };
  return scene.rotates() ? make.template operator()<true>() : make.template operator()<false>();
}

}  // namespace bagnold
