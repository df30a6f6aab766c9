// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// Scheme of a scene: as given. For "auto" it is two stages, in whose steps a run is counted
/// (src/config/ladder.hpp). For quasi-static steps it is backward Euler, which is not in Schemes.
std::string_view scheme_of(Scene const& scene);

/// Time step of the papers for a law, [tau_e], see kernels/physics/laws/paper_time_step.hpp.
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scheme's own rule, [tau_e].
double rule_time_step(Scene const& scene, std::string_view scheme);

/// Largest rate at which the drag of a drive relaxes a disk alone, [1 / tau_e]; 0 without one.
double drag_rate(Scene const& scene);

/// Time step of a scene: as given, or by the rule named, with a drive at most 0.2/drag_rate(); of a
/// ramp shortened to divide ramp_every. For quasi-static steps a strain of 1e-3.
double time_step(Scene const& scene);

/// Scene with scheme and time step resolved, as kept with results. Left unresolved: the step of
/// quasi-static cascades, and "auto" where the method may change.
Scene resolved(Scene scene);

}  // namespace bagnold
