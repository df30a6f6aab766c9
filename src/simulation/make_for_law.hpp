// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <memory>

#include "src/config/time_step.hpp"
#include "src/simulation/backends.hpp"
#include "src/simulation/block_engine.hpp"
#include "src/simulation/laws.hpp"
#include "src/simulation/reference_engine.hpp"

namespace bagnold {

/// The simulation of a scene under one law; nullptr if the build has no such backend. Each law is
/// instantiated in a source file of its own, src/simulation/law_*.cpp.
template <ContactLaw Law>
std::unique_ptr<Simulation> make_for_law(Scene const& scene, Snapshot const& snapshot,
                                         std::string const& backend);

namespace detail {

template <ContactLaw Law, class Space>
std::unique_ptr<Simulation> make_on_backend(Scene const& scene, Snapshot const& snapshot) {
  auto const law = make_law<Law>(scene.disks);
  auto const table = make_species_table(scene.mass_by_area());
  auto const make = [&]<class Repulsion>(Repulsion) -> std::unique_ptr<Simulation> {
    auto const make_engine = [&]<class Engine>(std::type_identity<Engine>, auto... stepping) {
      return std::make_unique<Engine>(stepping..., law, table, scene.shear.strain_rate,
                                      time_step(scene), scene.integration.skin, snapshot);
    };
    [[maybe_unused]] auto const& engine = scene.integration.engine;
    if constexpr (!is_device<Space>)
      if (engine != "reference")
        return make_engine(std::type_identity<BlockEngine<Law, Repulsion, Space>>{},
                           engine == "contact-rich" ? Stepping::contact_rich
                           : engine == "dense"      ? Stepping::dense
                           : engine == "windowed"   ? Stepping::windowed
                                                    : Stepping::automatic);
    return make_engine(std::type_identity<ReferenceEngine<Law, Repulsion, Space>>{});
  };
  return with_repulsion(scene.disks, make);
}

template <ContactLaw Law, class... Spaces>
std::unique_ptr<Simulation> make_on_any(std::tuple<Spaces...> const*, Scene const& scene,
                                        Snapshot const& snapshot, std::string const& backend) {
  std::unique_ptr<Simulation> made;
  ((backend == backend_name<Spaces> ? void(made = make_on_backend<Law, Spaces>(scene, snapshot))
                                    : void()),
   ...);
  return made;
}

}  // namespace detail

template <ContactLaw Law>
std::unique_ptr<Simulation> make_for_law(Scene const& scene, Snapshot const& snapshot,
                                         std::string const& backend) {
  return detail::make_on_any<Law>(static_cast<Backends const*>(nullptr), scene, snapshot,
                                  backend);
}

}  // namespace bagnold
