// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/make_quasi_static.hpp"

#include <utility>

#include "src/config/laws.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/device_copy.hpp"
#include "src/engine/quasi_static/quasi_static_engine.hpp"

namespace bagnold {

std::unique_ptr<Simulation> make_quasi_static(Scene const& scene, Snapshot const& snapshot) {
  auto const constants = law_of(scene.disks).constants(scene.disks);
  quasi_static::Material material{species_of(snapshot.state.diameter),
                                  make_species_table(scene.mass_by_area()), constants.normal,
                                  constants.tangential};
  auto const make = [&]<bool rotates>() -> std::unique_ptr<Simulation> {
    return std::make_unique<QuasiStaticEngine<rotates>>(std::move(material), strain_rates(scene),
                                                        time_step(scene), skin(scene), snapshot);
  };
  return scene.rotates() ? make.template operator()<true>() : make.template operator()<false>();
}

}  // namespace bagnold
