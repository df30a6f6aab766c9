// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene_physics.hpp"

namespace bagnold {

/// The law with the constants of a scene.
template <ContactLaw Law>
Law make_law(Scene::Disks const& disks) {
  return Law::make(damping_input(disks));
}

}  // namespace bagnold
