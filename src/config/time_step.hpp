// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// The scheme of a scene: as given, or where it is "auto" two stages, which bear every time step
/// that the papers' scheme bears.
std::string_view scheme_of(Scene const& scene);

/// The papers' time step of a law, [tau_e], see kernels/physics/laws/paper_time_step.hpp.
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scheme's own rule, [tau_e].
double rule_time_step(Scene const& scene, std::string_view scheme);

/// Largest rate at which the drag of a drive relaxes a disk alone, [1 / tau_e]; 0 without one.
double drag_rate(Scene const& scene);

/// The time step of a scene: as given, or by the rule named, with a drive at most 0.2/drag_rate();
/// of a ramp shortened to divide ramp_every.
double time_step(Scene const& scene);

/// The scene with scheme and time step told instead of ruled, as it is kept beside results.
Scene resolved(Scene scene);

}  // namespace bagnold
