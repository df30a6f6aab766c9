// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/laws.hpp"
#include "tests/reference/parameters.hpp"

namespace bagnold::test {

/// Gives the all-pairs reference the law of a scene. Throws reference::NoFormula with its name.
inline void set_law(reference::Parameters& p, Scene::Disks const& disks) {
  p.elasticity = disks.elasticity;
  p.damping_normal = disks.damping_normal;
  p.damping_tangential = disks.damping_tangential;
  auto const& law = law_of(disks);
  auto const constants = law.constants(disks);
  bool const linear = constants.normal != 0 || constants.tangential != 0;
  reference::set_law(p, law.name,
                     linear ? std::optional<reference::LinearLaw>(
                                  {law.rotates, constants.normal, constants.tangential})
                            : std::nullopt);
}

}  // namespace bagnold::test
