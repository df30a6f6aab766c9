// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "src/config/scene.hpp"

/// Input of the law of a scene. For .cpp files: code that only reads scenes needs no formulas.
namespace bagnold {

inline DampingInput damping_input(Scene::Disks const& disks) {
  return {disks.elasticity, disks.damping_normal, disks.damping_tangential};
}

/// The law with the constants of a scene.
template <ContactLaw Law>
Law make_law(Scene::Disks const& disks) {
  return Law::make(damping_input(disks));
}

}  // namespace bagnold
