// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <optional>
#include <tuple>
#include <type_traits>

#include "kernels/physics/schemes/scheme.hpp"
#include "src/config/errors.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/laws.hpp"

namespace bagnold {

/// use(law, repulsion, scheme) with the constants of a scene, under one law; scheme: a
/// std::integral_constant. Throws InputError where the law cannot do the scheme.
template <ContactLaw Law, class Use>
auto with_physics_of(Scene const& scene, Use const& use) {
  auto const law = make_law<Law>(scene.disks);
  auto const under = [&](auto scheme) {
    return with_repulsion(scene.disks,
                          [&](auto const& repulsion) { return use(law, repulsion, scheme); });
  };
  if (scheme_of(scene) == two_stage_scheme) {
    if constexpr (TwoStageLaw<Law>)
      return under(std::integral_constant<Scheme, Scheme::two_stage_leapfrog>{});
    else
      throw InputError(fmt::format(
          "integration.scheme = \"{}\" ({} cannot do model {}, whose damping is not linear in the "
          "velocity, "
          "or neither normal nor isotropic and without spins); set integration.scheme = \"{}\"",
          scene.integration.scheme, two_stage_scheme, Law::name, papers_scheme));
  }
  return under(std::integral_constant<Scheme, Scheme::modified_velocity_verlet>{});
}

/// Under the law of the scene, which is one of the program's. use: returns nothing.
template <class Use>
void with_physics(Scene const& scene, Use const& use) {
  [&]<class... Law>(std::tuple<Law...> const*) {
    ((scene.disks.model == Law::name ? with_physics_of<Law>(scene, use) : void()), ...);
  }(static_cast<Laws const*>(nullptr));
}

}  // namespace bagnold
