// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

/// The papers' time steps, [tau_e].
///
/// CD_n and general: min{0.5/Q, 0.1, 0.2 Q} (P1 Sec. II C). CD and CD_rot: 0.05, and below Q = 0.5
/// max(0.01, 0.1 Q), after P2 Sec. II D, which says "down to 0.01".
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scene: as given, or the papers', of a ramp shortened to divide ramp_every.
double time_step(Scene const& scene);

}  // namespace bagnold
