// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/make_block_engine.hpp"

#include <utility>

#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/blocks/block_engine.hpp"

namespace bagnold {

namespace {

Stepping stepping(Scene const& scene, bool iterates) {
  auto const& engine = scene.integration.engine;
  return scene.driven() || iterates  ? Stepping::many_contacts
         : engine == "many-contacts" ? Stepping::many_contacts
         : engine == "few-contacts"  ? Stepping::few_contacts
         : engine == "lookahead"     ? Stepping::lookahead
                                     : Stepping::automatic;
}

}  // namespace

std::unique_ptr<Simulation> make_block_engine(Scene const& scene, Snapshot& snapshot,
                                              std::optional<DriveSetup> const& drive,
                                              std::string const& backend, MakeStepper make) {
  auto loop = make_block_loop(backend);
  if (!loop) return nullptr;
  auto stepper = make(scene, drive);
  auto const steps = stepping(scene, stepper->needs.terms > 0);
  return std::make_unique<BlockEngine>(
      std::move(loop), std::move(stepper), steps, make_species_table(scene.mass_by_area()),
      strain_rates(scene), time_step(scene), skin(scene), snapshot);
}

}  // namespace bagnold
