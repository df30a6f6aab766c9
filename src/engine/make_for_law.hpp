// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <memory>

#include "kernels/cpu/steps/two_stage_block_step.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/blocks/block_engine.hpp"
#include "src/engine/laws.hpp"
#include "src/engine/reference/reference_engine.hpp"
#include "src/engine/with_scheme.hpp"

namespace bagnold {

/// The simulation of a scene under one law; nullptr if the build has no such backend. An engine
/// that needs room takes the snapshot's arrays, if it does not throw. Each law is instantiated in a source
/// file of its own, src/engine/law_*.cpp.
template <ContactLaw Law>
std::unique_ptr<Simulation> make_for_law(Scene const& scene, Snapshot& snapshot,
                                         std::string const& backend);

namespace detail {

inline Stepping stepping(std::string const& engine) {
  return engine == "contact-rich" ? Stepping::contact_rich
         : engine == "dense"      ? Stepping::dense
         : engine == "windowed"   ? Stepping::windowed
                                  : Stepping::automatic;
}

/// make(Engine's type, what it takes beside what all engines take). Step: of blocks, under one law.
template <class Step, class... Spaces, class Make>
std::unique_ptr<Simulation> make_engine(std::tuple<Spaces...> const*, std::string const& engine,
                                        std::string const& backend, Make const& make) {
  if (engine != "reference")
    if (auto loop = make_block_loop(backend))
      return make(std::type_identity<BlockEngine<Step>>{}, std::move(loop), stepping(engine));
  std::unique_ptr<Simulation> made;
  ((backend == backend_name<Spaces>
        ? void(made = make(std::type_identity<ReferenceEngine<typename Step::Law, typename Step::Repulsion,
                                                              Spaces, Step::scheme>>{}))
        : void()),
   ...);
  return made;
}

}  // namespace detail

template <ContactLaw Law>
std::unique_ptr<Simulation> make_for_law(Scene const& scene, Snapshot& snapshot,
                                         std::string const& backend) {
  auto const make = [&]<class Engine>(std::type_identity<Engine>, auto&&... more) {
    return std::unique_ptr<Simulation>(std::make_unique<Engine>(
        std::move(more)..., make_law<Law>(scene.disks), make_species_table(scene.mass_by_area()),
        scene.shear.strain_rate, time_step(scene), scene.integration.skin, snapshot));
  };
  auto const make_step = [&]<class Step>(std::type_identity<Step>) {
    return detail::make_engine<Step>(static_cast<Backends const*>(nullptr),
                                     scene.integration.engine, backend, make);
  };
  auto const make_with = [&]<class Repulsion>(Repulsion) {
    return with_scheme<Law>(scene, [&]<Scheme stepped>(std::integral_constant<Scheme, stepped>) {
      if constexpr (stepped == Scheme::two_stage_leapfrog)
        return make_step(std::type_identity<TwoStageBlockStep<Law, Repulsion>>{});
      else
        return make_step(std::type_identity<BlockStep<Law, Repulsion>>{});
    });
  };
  return with_repulsion(scene.disks, make_with);
}

}  // namespace bagnold
