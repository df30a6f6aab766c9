// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/make_quasi_static.hpp"

#include <utility>

#include "src/engine/device_copy.hpp"
#include "src/engine/quasi_static/quasi_static_engine.hpp"

namespace bagnold {

std::unique_ptr<Simulation> make_quasi_static(EngineInput const& input, Snapshot const& snapshot) {
  quasi_static::Material material{species_of(snapshot.state.diameter), input.species,
                                  input.normal_damping, input.tangential_damping};
  auto const make = [&]<bool rotates>() -> std::unique_ptr<Simulation> {
    return std::make_unique<QuasiStaticEngine<rotates>>(std::move(material), input.rates,
                                                        input.time_step, input.skin, snapshot);
  };
  return input.rotates ? make.template operator()<true>() : make.template operator()<false>();
}

}  // namespace bagnold
