// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <type_traits>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/scheme.hpp"
#include "src/config/errors.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

/// use(std::integral_constant of the Scheme of a scene). Throws InputError where the law cannot do
/// it.
template <ContactLaw Law, class Use>
auto with_scheme(Scene const& scene, Use const& use) {
  if (scheme_of(scene) == two_stage_scheme) {
    if constexpr (TwoStageLaw<Law>)
      return use(std::integral_constant<Scheme, Scheme::two_stage_leapfrog>{});
    else
      throw InputError(fmt::format(
          "integration.scheme = \"{}\" ({} cannot do model {}, whose damping is not linear in the "
          "velocity, "
          "or neither normal nor isotropic and without spins); set integration.scheme = \"{}\"",
          scene.integration.scheme, two_stage_scheme, Law::name, papers_scheme));
  }
  return use(std::integral_constant<Scheme, Scheme::modified_velocity_verlet>{});
}

}  // namespace bagnold
