// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/time_step.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/ensemble/ensemble_engine.hpp"
#include "src/engine/laws.hpp"
#include "src/engine/with_scheme.hpp"

namespace bagnold {

/// An ensemble of a scene's systems under one law, on a backend that is a device; nullptr if the
/// build has no such. Instantiated with make_for_law.
template <ContactLaw Law>
std::shared_ptr<Ensemble> make_together_for_law(Scene const& scene,
                                                std::vector<Snapshot> const& snapshots,
                                                std::string const& backend);

namespace detail {

template <ContactLaw Law, class Space>
std::shared_ptr<Ensemble> make_together_on(Scene const& scene,
                                           std::vector<Snapshot> const& snapshots) {
  auto const make = [&]<class Engine>(std::type_identity<Engine>) -> std::shared_ptr<Ensemble> {
    return std::make_shared<Engine>(
        make_law<Law>(scene.disks), make_species_table(scene.mass_by_area()),
        scene.shear.strain_rate, time_step(scene), scene.integration.skin, snapshots);
  };
  auto const make_with = [&]<class Repulsion>(Repulsion) {
    return with_scheme<Law>(scene, [&]<Scheme stepped>(std::integral_constant<Scheme, stepped>) {
      return make(std::type_identity<EnsembleEngine<Law, Repulsion, Space, stepped>>{});
    });
  };
  return with_repulsion(scene.disks, make_with);
}

template <ContactLaw Law, class... Spaces>
std::shared_ptr<Ensemble> make_together_on_any(std::tuple<Spaces...> const*,
                                               [[maybe_unused]] Scene const& scene,
                                               [[maybe_unused]] std::vector<Snapshot> const& from,
                                               std::string const& backend) {
  std::shared_ptr<Ensemble> made;
  auto const try_on = [&]<class Space>(std::type_identity<Space>) {
    if constexpr (is_device<Space>)
      if (backend == backend_name<Space>) made = make_together_on<Law, Space>(scene, from);
  };
  (try_on(std::type_identity<Spaces>{}), ...);
  return made;
}

}  // namespace detail

template <ContactLaw Law>
std::shared_ptr<Ensemble> make_together_for_law(Scene const& scene,
                                                std::vector<Snapshot> const& snapshots,
                                                std::string const& backend) {
  return detail::make_together_on_any<Law>(static_cast<Backends const*>(nullptr), scene, snapshots,
                                           backend);
}

}  // namespace bagnold
