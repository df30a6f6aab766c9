// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// The scheme of a scene: as given, or where it is "auto" two stages, which bear every time step that
/// the papers' scheme bears.
std::string_view scheme_of(Scene const& scene);

/// The papers' time steps, [tau_e].
///
/// CD_n and general: min{0.5/Q, 0.1, 0.2 Q} (P1 Sec. II C). CD and CD_rot: 0.05, and below Q = 0.5
/// max(0.01, 0.1 Q), after P2 Sec. II D, which says "down to 0.01".
double paper_time_step(Scene::Disks const& disks);

/// Those of two stages, [tau_e]: min{0.2, 0.2 Q} where disks rotate, otherwise min{0.2, 0.5 Q}, with Q
/// over the larger damping constant of the model general. Biases are below 1% (docs/accuracy.md).
double two_stage_time_step(Scene const& scene);

/// The time step of a scene: as given, or by the rule named; of a ramp shortened to divide ramp_every.
double time_step(Scene const& scene);

/// The scene with scheme and time step told instead of ruled, as it is kept beside results.
Scene resolved(Scene scene);

}  // namespace bagnold
